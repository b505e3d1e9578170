/*
 * dem.h -- public interface of Suna's discrete element library.
 *
 * A simulation is created, given a scene (effects, materials, walls, particles, as text in
 * OpenFOAM's dictionary syntax), set up, advanced and freed:
 *
 *     dem_create -> dem_scene_text | dem_scene_file, dem_set, dem_add_wall, dem_add_particles,
 *                   dem_load
 *                -> (dem_check) -> dem_setup -> dem_advance, queries, dem_save ... -> dem_free
 *
 * Types: the status codes and all structs are in dem_types.h, in sections of the same titles.
 *
 * Return values: functions that can fail return DEM_OK (0) or another status (DEM_ERROR_...);
 * dem_error_text() then gives one sentence with the thing, the value, the limit and the cure. A
 * call out of order returns DEM_ERROR_STATE. Functions that return no status may be called at any
 * time and with any number: before what they describe exists, and for a number out of range,
 * numbers and counts are 0, texts are empty and pointers to data are NULL, unless the comment says
 * otherwise.
 *
 * Collective: such a function is called by all ranks of the communicator together and fails on all
 * of them together.
 *
 * Ownership: arguments are copied, unless the comment says otherwise. Arrays and texts that the
 * library returns belong to it; the comment says how long they are valid. Nothing is to be freed
 * but the simulation.
 *
 * Units are SI; vectors are x, y, z. "Contiguous, 3 each" is an array x0 y0 z0 x1 y1 z1 ...
 *
 * The library never prints or exits, and never aborts by itself.
 *
 * MPI: with MPI_COMM_NULL no MPI call is made. Otherwise the library works on its own duplicate of
 * the communicator, on which it sets MPI_ERRORS_RETURN: an error of a call on it is returned as
 * DEM_ERROR_MPI, with MPI's text, and not handled by the error handler of the caller's
 * communicator. There are three exceptions: MPI_Comm_dup in dem_create uses the handler of the
 * caller's communicator; calls that belong to no communicator (data types, MPI_Get_count) use the
 * handler of MPI_COMM_WORLD or MPI_COMM_SELF; MPI or the batch system may end the program, for
 * example when a rank is killed. After DEM_ERROR_MPI the ranks may be out of step: call nothing but
 * dem_error_text and dem_free, end the program, and restart from the last snapshot. A rank may then
 * wait for another one that has returned; MPI_Abort ends both.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_H
#define DEM_H

#include "dem_types.h"

#include <mpi.h>
#include <signal.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version, in its one place: the build, the packages and dem_version read it here. The first
   number, also in the name of the shared library, changes when a struct or a function of this
   header changes. */
#define DEM_VERSION "0.1.0"

struct dem;

/* DEM_VERSION of the library that is loaded. */
const char *dem_version(void);

/* The message of the last error of this thread; empty before the first. Valid until the next
   error. Never NULL. */
const char *dem_error_text(void);

/* Make the error for an unknown word, e.g. `what` = "option": always fails, with a message that
   lists the n known words, the most similar first. */
int dem_did_you_mean_error(const char *what, const char *word, const char *const *known, int n);

/* ---- create and free ------------------------------------------------------------------------- */

/* Collective. Create an empty simulation; the caller frees it with dem_free. The communicator is
   duplicated; MPI_COMM_NULL runs on one rank without MPI. On failure the pointer is NULL. */
int dem_create(struct dem **, MPI_Comm);

/* The same for other languages: the communicator's Fortran handle; -1 for MPI_COMM_NULL. */
int dem_create_fortran(struct dem **, int comm);
void dem_free(struct dem *);  /* collective; NULL is allowed */

/* ---- scene: before dem_check ----------------------------------------------------------------- */

/* The scene's dictionary, for entries that belong to the program (functions in
   input/dictionary.h). Read these before dem_check, which refuses entries that nothing has read.
   NULL before a scene is read; valid until dem_free. */
struct dem_dict;
const struct dem_dict *dem_scene_dict(const struct dem *);

/* The same without that header, by path ("time/end"), for other languages. dem_scene_value: the text
   of a value, its words separated by blanks, valid until the next call; NULL for a group, and where
   there is no entry. dem_scene_name: the name of entry k of a group, from 0 ("" is the whole scene);
   NULL behind the last. dem_scene_skip: nothing will read this entry or group. The first and the
   last count as reading it. */
const char *dem_scene_value(struct dem *, const char *path);
const char *dem_scene_name(const struct dem *, const char *path, int k);
void dem_scene_skip(struct dem *, const char *path);

/* Read a scene, once, from a file or from a text; `name` stands for the file name in messages. */
int dem_scene_file(struct dem *, const char *path);
int dem_scene_text(struct dem *, const char *text, const char *name);

/* Override or add one entry of the scene, e.g. dem_set(d, "effects/dry/restitution", "0.9"). */
int dem_set(struct dem *, const char *path, const char *value);

/* Remove an effect from the entries `effects` and `pairs` of the scene. An error when the scene
   does not have it. */
int dem_remove_effect(struct dem *, const char *effect);

/* Collective. Add a wall of n triangles: 9 numbers each [m], three corners. Ranks may give all
   triangles or each its own ones; a triangle given by two ranks counts once. No other wall may
   have this name; the material is one of the scene. */
int dem_add_wall(struct dem *, const char *name, const char *material, int64_t n,
                 const double *triangles);

/* Collective. Move a wall of dem_add_wall, e.g. with a moving mesh: its corners [m], the same
   number of triangles in the same order as this rank added.
   Before dem_setup: the present position, where dem_add_wall was given the original mesh. Contacts
   are identified by the original surface, so a restarted run adds the same one.
   After dem_setup: the position at the end of the next dem_advance; corners move linearly in
   time until then. A wall for which it is not called stays at rest. */
int dem_wall_move(struct dem *, const char *name, int64_t n, const double *triangles);

/* Collective, before dem_check. The closed surface of a mesh (zone 0), or of one of its zones of
   cells, of this name: n triangles of this rank, 9 numbers each [m], corners counterclockwise as
   seen from outside. Groups of `insert` name it by `inside mesh` or `zone NAME`. */
int dem_insert_region(struct dem *, const char *name, int zone, int64_t n,
                      const double *triangles);

/* Add particles besides the scene's own. Every rank gives the same list. */
int dem_add_particles(struct dem *, int64_t n, const struct dem_new_particle *);

/* ---- check and set-up ------------------------------------------------------------------------ */

/* Collective. Read the scene and check all that can be checked before particles are placed,
   which may take long. Entries that nothing has read are refused. After an error, also of
   dem_setup, the simulation can only be freed. */
int dem_check(struct dem *);

/* Collective. Set up: check, unless dem_check has done it; insert the particles or load the
   snapshot, freeze the interaction table, distribute particles to ranks. Takes long for dense
   random packings. */
int dem_setup(struct dem *);

/* ---- plan ------------------------------------------------------------------------------------ */

/* Collective, after dem_setup; in coupled runs after the fluid columns have been written. A
   report on the run ahead: effects, walls, particles, time step, bed, fluid, memory and run
   time, as lines of text, the same on all ranks, valid until the next dem_plan or dem_free.
   Measures steps of as many particles as a rank has, at most 250000, for a tenth of a second or 20
   steps. No particle moves; views stay valid. */
int dem_plan(struct dem *, const struct dem_run_info *, const char **text);

/* Collective, as dem_plan. What of the scene is likely to be a mistake or cannot work, as a numbered
   list under the line WARNINGS, each item with the entry to change; *text is "" when there is
   nothing. `own`: n sentences of the program, which come first. Valid until the next call. */
int dem_warnings(struct dem *, const struct dem_run_info *, int n, const char *const *own,
                 const char **text);

/* Collective, between two advances, with the largest overlap that dem_totals has returned since the
   last call. *text: a sentence when contacts overlap by more than 10 %, or when a particle is faster
   than impactSpeed so that its impacts will overlap by more than 5 %, with the settings to take;
   "" otherwise, and when it was said before, unless it has grown by half. */
int dem_impact_warning(struct dem *, double overlap, const char **text);

/* Collective, after dem_setup. The slab of the bed between 10 and 90 % of the volume of the particles
   that move: heights x . up [m], up against gravity. Returns 0, and zeros, without gravity or such
   particles. */
int dem_bed_slab(const struct dem *, double up[3], double *low, double *high);

/* Returns the number of verdicts of the last dem_plan. They are valid until the next one. */
int dem_verdicts(const struct dem *, const struct dem_verdict **);

/* After dem_check. The comment at the head of result files: "effects: " and the names of all active
   effects, in the order of their stages. dem_effect_names: the names only;
   dem_fluid_effect_names: of fluid effects only. Valid until dem_free. */
const char *dem_heading(const struct dem *);
const char *dem_effect_names(const struct dem *);
const char *dem_fluid_effect_names(const struct dem *);

/* After dem_check, by one rank. Enter the active effects into FOLDER/effects.csv, for the CSV tables
   beside it, which have no comments: they act in a run that starts at this time [s]. The rows of an
   earlier run from then on are removed; no row is added while its effects are those above. The
   folder must exist. */
int dem_effects_record(const struct dem *, const char *folder, double start);

/* The traits of the effect with this name (enum dem_effect_trait, or-ed); 0 without any, and for a
   name that no effect has. Needs no simulation. */
unsigned dem_effect_traits(const char *effect);

/* After dem_check. Sets g to the uniform acceleration of all particles [m/s2], zero without one.
   Returns 1 if an effect of the scene gives it, else 0. */
int dem_gravity_acceleration(const struct dem *, double g[3]);

/* ---- effects --------------------------------------------------------------------------------- */

/* The name of effect number k of the library's list, from 0; NULL for another number. Needs no
   simulation. */
const char *dem_effect_name(int k);

/* An effect as text: name, stage, what it does, source, limitation; each setting with unit, default,
   range and meaning. All effects with NULL. DEM_ERROR_INPUT for a name that no effect has. The
   simulation needs no scene. *text is valid until the next call, or dem_free. */
int dem_effect_text(struct dem *, const char *effect, const char **text);

/* ---- advance --------------------------------------------------------------------------------- */

/* Collective. Advance by `duration` [s] > 0 in equal steps that are no longer than
   dem_step_limit().used. Positions and velocities are at the same time before and after. After
   an error the message names the particle or wall that caused it, and the run cannot continue,
   except from a backup (dem_restore) or a snapshot. */
int dem_advance(struct dem *, double duration);

/* From now on dem_advance reads *asked after each step, for a program that catches signals. When
   it is not 0 on any rank, all ranks return DEM_OK after that step, which may be before the end
   of the advance, with velocities half a step ahead of positions. Only then dem_stopped returns
   the largest *asked of all ranks; otherwise 0. The run may be saved there, or advanced by the
   rest of the duration: then it has the same bits as without the stop, also after a load on
   another number of ranks. The pointer must stay valid. */
void dem_set_stop_flag(struct dem *, const volatile sig_atomic_t *asked);
int dem_stopped(const struct dem *);

/* Catch SIGTERM, SIGUSR1 and SIGINT from now on, except the signals in `except` (NULL for none).
   Returns where the number of the last one is stored, 0 before the first. A second SIGINT ends the
   program. */
const volatile sig_atomic_t *dem_catch_signals(const int *except, int exceptions);
const char *dem_signal_name(int signal);                  /* of these and DEM_STOP_FILE; else "" */

/* Take signals of dem_catch_signals back from a library that has put a handler of its own there. */
void dem_keep_signals(void);

/* A stop for a run that signals do not reach: a file, as a rule `stop` in the run's folder.
   dem_stop_file_look, between two steps on one rank, also in the function of dem_set_progress: look
   for it, at most once a second of the clock; when it is there, remove it and store DEM_STOP_FILE
   where dem_catch_signals stores the number of a signal.
   dem_stop_file_clear, before the first step: remove one that was there before; *found: 1 when it was.
   An error when it is there and cannot be removed. */
int dem_stop_file_clear(const char *path, int *found);
void dem_stop_file_look(const char *path);

/* On one rank: lock a folder, which must exist, by a file `lock` with process and host. The kernel
   frees the lock of a process that has been killed; the next run takes the file over, and `before`
   names the process. DEM_ERROR_STATE when another run has the folder. dem_folder_unlock removes
   the file; it does nothing without a lock. */
int dem_folder_lock(struct dem_folder_lock *, const char *folder);
void dem_folder_unlock(struct dem_folder_lock *);

/* Where the number of a second request is stored, a signal or the file, that comes two seconds or
   more after the first: stop without waiting. 0 before. Needs no simulation. */
const volatile sig_atomic_t *dem_repeated_signal(void);

/* From now on dem_advance calls `report` on this rank, at most once in `seconds` of the clock, with
   `self`, the simulated time [s] and the number of steps made so far. Of the library it may call
   dem_stop_file_look and dem_keep_signals only.
   NULL ends it. */
void dem_set_progress(struct dem *, double seconds,
                      void (*report)(void *self, double time, int64_t steps), void *self);

/* The longest stable step and the step in use. After dem_check; with a snapshot after dem_setup;
   zeros before. */
struct dem_step_limit dem_step_limit(const struct dem *);

/* ---- totals, profile, energy ----------------------------------------------------------------- */

/* Collective. Sums over all particles and contacts; resets the largest overlap. */
int dem_totals(struct dem *, struct dem_totals *);

/* Collective, after dem_setup, between two advances. The cost of the run since dem_setup. Has no
   influence on the run. */
int dem_profile(struct dem *, struct dem_profile *);

/* Collective. The profile as text, the same on all ranks, valid until the next call or dem_free. */
int dem_profile_text(struct dem *, const char **text);

/* The energy balance. dem_energy_enable, called before dem_setup, switches it on.
   dem_energy, collective: kinetic and elastic energies are the present ones, all other terms are
   sums since the time *since [s]. Terms of all ranks, in the same order at each call; valid
   until the next. */
int dem_energy_enable(struct dem *);
int dem_energy(struct dem *, double *since, int *n, const struct dem_energy_item **item);

/* Called before dem_setup: integrate the orientation of each particle, a unit quaternion
   (cos(a/2), n sin(a/2)): the rotation by the angle a about the axis n since the start, or since
   the first run that has integrated it (snapshots hold it). No effect depends on it. */
int dem_orientation_enable(struct dem *);

/* Collective. The number of particles with more kinetic energy than `energy` [J], translation
   and rotation. */
int dem_count_moving(struct dem *, double energy, int64_t *n);

/* Rest, as time/untilQuiet defines it. dem_quiet_read, before dem_check: read that entry; without
   one the defaults, with `wanted` 0. dem_quiet_check, after dem_check: an error when the scene has
   no gravity to compare with. dem_quiet_tests: the number of tests in an interval [s].
   dem_quiet_test, collective, does nothing unless `wanted`: test with the present totals, set
   `reached`. */
int dem_quiet_read(const struct dem *, struct dem_quiet *);
int dem_quiet_check(const struct dem *, const struct dem_quiet *);
int64_t dem_quiet_tests(const struct dem *, const struct dem_quiet *, double interval);
int dem_quiet_test(struct dem *, struct dem_quiet *, const struct dem_totals *);

/* Collective. A 64-bit hash of particles and contact history, the same on any number of ranks. */
int dem_hash(struct dem *, uint64_t *hash);

/* ---- lost particles, streams and outlets ----------------------------------------------------- */

/* Collective. Losses of all ranks since the last call, sorted by time and id; the same list on
   every rank and on any number of ranks. Valid until the next call.
   Losses and broken bonds are recorded in any case, with 288 and 64 bytes each, until dem_lost
   and dem_broken_bonds return them, also across dem_restore: a long run calls both now and then. */
int dem_lost(struct dem *, int64_t *n, const struct dem_loss **);

/* Streams, outlets, and the domain if particles may leave it, in this order; none in a scene
   without streams and outlets. The same on all ranks; valid until the next call. */
int dem_flows(struct dem *, int *n, const struct dem_flow **);

/* Before dem_check, for a program that must know all particles before it advances them (a fluid
   is coupled): streams and outlets act in dem_flow_apply only, and the scene may name patches
   of a mesh. */
int dem_flow_on_request(struct dem *);

/* Collective. A patch through which particles enter: n triangles of this rank, 9 numbers each
   [m], corners counterclockwise as seen from outside the mesh, and the velocity of the fluid on
   each, 3 numbers [m/s], or NULL. Called before dem_check for each patch of the scene's
   `insert`, and again whenever triangles or velocities change. */
int dem_flow_patch(struct dem *, const char *name, int64_t n, const double *triangles,
                   const double *velocity);

/* Particles of this rank that have crossed the patch of an outlet: they are removed in the next
   dem_flow_apply. */
int dem_flow_remove(struct dem *, const char *patch, int64_t n, const int64_t *id);

/* Collective, between two advances. Remove the particles of dem_flow_remove and those inside an
   outlet of the scene, and insert those that are due. *changed: 1 when any rank has lost or
   gained a particle. Then views and fluid columns must be fetched again; `location` of new
   particles is -1. */
int dem_flow_apply(struct dem *, int *changed);

/* ---- bonds ----------------------------------------------------------------------------------- */

int dem_has_bonds(const struct dem *);  /* 1 when an effect of the scene makes bonds */

/* The bonds whose lower particle this rank owns, as of the last step; none after a load or
   restore, before the first step. Valid until the next call. */
int dem_bonds(struct dem *, int64_t *n, const struct dem_bond **);

/* Collective. The bonds of all ranks that broke since the last call, as in dem_lost. */
int dem_broken_bonds(struct dem *, int64_t *n, const struct dem_broken_bond **);
const char *dem_broken_bond_cause(int cause);  /* "tension", "shear", "distance" */

/* Collective. Write the intact bonds for ParaView: a line between partners, in FOLDER/FILE, and
   its entry for this time [s] in FOLDER/bonds.pvd. The folder must exist. */
int dem_bonds_draw(struct dem *, const char *folder, const char *file, double time);

/* ---- walls and averages ---------------------------------------------------------------------- */

/* After dem_check walls are numbered from 0 to dem_wall_count - 1. dem_wall_name: "" for another
   number. dem_wall_load, collective: the present force of particles on a wall [N], and its torque
   about the origin [N m]. */
int dem_wall_count(const struct dem *);
const char *dem_wall_name(const struct dem *, int wall);
int dem_wall_load(struct dem *, int wall, double force[3], double torque[3]);

/* Averages on the grids of the scene's `averages`, also of particle scalars, sampled during
   dem_advance. dem_averages: the first rank writes NAME.csv and NAME.vti of each grid that has
   samples into the folder, which must exist. All ranks call it; only the first can fail. */
int dem_averages_count(const struct dem *);
int dem_averages(struct dem *, const char *folder);

/* Impulse of particles on a wall [N s] and its moment about the origin [N m s] since the last
   dem_wall_impulse_reset, which starts or resets the sums of all walls. Divided by the time since,
   they are mean force and torque. dem_wall_impulse is collective. */
int dem_wall_impulse_reset(struct dem *);
int dem_wall_impulse(struct dem *, int wall, double impulse[3], double angular_impulse[3]);

/* Number of triangles of a wall, and whether it moves; zeros for a number that no wall has. */
void dem_wall_info(const struct dem *, int wall, struct dem_wall_info *);

/* Collective. Write the present corners of a wall's triangles [m], 9 numbers each, into an array of
   9*dem_wall_info.triangles numbers of the first rank; other ranks may give NULL. The order is
   always the same. */
int dem_wall_corners(struct dem *, int wall, double *corners);

/* ---- particles ------------------------------------------------------------------------------- */

/* The particles that this rank owns: pointers into the library's arrays, for reading. All is 0
   before dem_setup. */
void dem_view(const struct dem *, struct dem_view *);

/* Contact stress times volume [J] of each particle of the view: xx yy zz xy yz zx of the sum of
   force times branch vector over its contacts, tension positive (records/virial.h). Sums
   over a region divided by its volume are the contact stress. `virial` has 6 numbers a particle;
   all are 0 after a load or restore, before the first step.
   dem_virial_enable, called before dem_setup, keeps the forces of all contacts for it: 64 bytes a
   candidate contact, 96 with moments; some 180 a particle of a dense bed. */
int dem_virial_enable(struct dem *);
int dem_virial(struct dem *, double *virial);
const char *dem_material_name(const struct dem *, int material);  /* "" for an unknown number */

/* The value of a particle in a column with a stride [byte]. */
static inline const double *dem_at(const double *column, size_t stride, size_t particle)
{
    return (const double *)(const void *)((const char *)column + stride*particle);
}

/* ---- particle scalars ------------------------------------------------------------------------ */

/* After dem_check. The number of particle scalars that the effects of the scene declare
   (temperature, ...), and what is known of number k: zeros and empty texts for another number.
   dem_scalar_index: the number of one, or -1. */
int dem_scalar_count(const struct dem *);
void dem_scalar_info(const struct dem *, int k, struct dem_scalar_info *);
int dem_scalar_index(const struct dem *, const char *name);

/* After dem_setup. The values of scalar k of the owned particles, in the order of dem_view, to be read
   or, between two advances, written. Valid until the next collective call. NULL for another number,
   and before. */
double *dem_scalar(struct dem *, int k);

/* Before dem_check. The program exchanges this scalar of the scene's effects: dem_scalar_exchange
   gives columns also where no fluid effect of the scene exchanges it. */
int dem_scalar_exchange_enable(struct dem *, const char *name);

/* After dem_setup. The columns of the exchange of scalar k. DEM_ERROR_STATE when it is not exchanged. */
int dem_scalar_exchange(struct dem *, int k, struct dem_scalar_exchange *);

/* After the partner of the exchange is solved, with its new value s*' at the particles: leave
   R (s*' - s*) for the next advance, s* the mean target of the last one. The partner must get its
   opposite. */
int dem_scalar_correct(struct dem *, int k, const double *target);

/* Collective, after dem_setup. The sum of C s over all particles, of scalar k with the capacity C: of
   the temperature, the heat of the particles above 0 K [J]. */
int dem_scalar_total(struct dem *, int k, double *total);

/* ---- coupled fluid --------------------------------------------------------------------------- */

/* After dem_check: 1 when an effect of the scene needs a fluid. */
int dem_needs_fluid(const struct dem *);

/* The columns. From the first call on the run counts as coupled; an error when the scene has its
   own `fluid`. */
int dem_fluid(struct dem *, struct dem_fluid *);

/* yes: drag is the law's b over the void fraction, the whole force of a steady uniform flow,
   which contains the force of its pressure gradient (set III of Zhou, Kuang, Chu, Yu, J. Fluid Mech.
   661 (2010) 482, "simplified model B"); the pressure gradient column must then be the
   hydrostatic one. no: the law's own b. Holds until the next call; not saved in snapshots. */
void dem_fluid_whole_drag(struct dem *, int yes);

/* Before dem_setup: the fluid's continuity contains the void fraction, so that particles displace
   it; it has this density [kg/m3]. Where the scene has pressureGradient and a material of less
   than 10 times the density, the columns under_relaxation and owed_pressure_impulse exist: without
   under-relaxation dense suspensions of light particles oscillate from step to step. */
void dem_fluid_set_displaced(struct dem *, double density);

/* DEM_ERROR_INPUT when an effect needs a fluid, and neither the scene nor dem_fluid gives one.
   After dem_check. */
int dem_require_fluid(const struct dem *);

/* Before dem_check and dem_setup: the coupled fluid has this density [kg/m3] everywhere. The effect
   stokes then counts added mass in its Stokes number. */
void dem_fluid_set_density(struct dem *, double density);

/* After an advance, where the column exists: set under_relaxation for the next one
   (laws/fluid/particle_exchange.h). Returns the smallest factor of this rank, 1 without. */
double dem_fluid_under_relax(struct dem *);

/* A value for the column slip_factor where continuity makes the fluid displace and particles get
   the correction for its new velocity: 1/e^2, or 1/e with whole drag; e limited to 0.1 and above
   (laws/fluid/particle_exchange.h). */
double dem_fluid_slip_factor(const struct dem *, double void_fraction);

/* A value for the column mean_diameter [m], the Sauter mean: from sum V [m3] and sum V/d [m2] of
   the particles around; 0 where there are none. */
double dem_sauter_diameter(double volume, double per_diameter);

/* The force of each particle on the fluid after an advance by `window` [s]: F - K u, with u the
   fluid's new velocity at the particle. `coefficient` gets K [kg/s], 1 each, `force` gets F [N],
   3 each. */
int dem_fluid_reaction(const struct dem *, double window, double *coefficient, double *force);

/* The largest rate at which drag takes up the slip of a particle of this rank [1/s]: b/(m + a),
   with b the mean drag coefficient over the last advance in a fluid of given velocity and a the
   added mass; 0 for frozen particles. */
double dem_fluid_relaxation(const struct dem *);

/* After the fluid is solved, with its new velocity u' and full pressure gradient grad p' at the
   particles (3 each, in the order of the columns): leave the impulse R (u' - u) + q V T (grad p'
   - grad p) for the next advance, with R `response`, q `transmitted_fraction`, V the particle's
   volume, T the window. The fluid must get its opposite. */
int dem_fluid_correct(struct dem *, const double *velocity, const double *pressure_gradient);

/* ---- means ----------------------------------------------------------------------------------- */

/* Means of many time series with 95 % intervals by block means (core/block_means.h); needs no
   simulation. `columns` numbers a sample, with a weight > 0 such as the time step; free with
   dem_means_free. DEM_ERROR_MEMORY when the blocks do not fit. */
struct dem_means;
int dem_means_create(struct dem_means **, size_t columns);
void dem_means_add(struct dem_means *, const double *sample, double weight);
void dem_means_free(struct dem_means *);    /* NULL is allowed */

/* The mean of each column and half the width of its interval; NaN with fewer than
   DEM_MEANS_MIN_BLOCKS full blocks, whose number is returned. */
int dem_means_get(const struct dem_means *, double *mean, double *half_width);

/* ---- save and restore ------------------------------------------------------------------------ */

/* Collective, after dem_setup. Write a snapshot: all ranks write one temporary file, which is
   verified, flushed to disk and renamed, so that a file of that name stays until the new one is
   complete. A snapshot loads on any number of ranks and the run continues with the same bits. After a
   dem_advance that failed it is refused, until dem_restore: a good snapshot stays. */
int dem_save(struct dem *, const char *path);

/* Not collective; needs no simulation. The hash of the state in a snapshot, as dem_hash returns
   it. */
int dem_snapshot_hash(const char *path, uint64_t *hash);

/* Continue from a snapshot: after the scene, before dem_check. The file is read in dem_setup. The scene
   may be an edited one: groups of `insert` that the snapshot does not have are inserted, walls go on
   from where they stood, and dem_warnings names every difference. */
int dem_load(struct dem *, const char *path);

/* The same for a state that another run has made, as the scene's entry `start` does, whose other
   entries hold if the scene has one: dem_setup refuses an overlap with a wall of more than 0.05 of a
   diameter that is also more than twice the largest between particles. dem_start_overlap: what it
   found, after dem_setup; zeros without a check. */
int dem_start(struct dem *, const char *path);
void dem_start_overlap(const struct dem *, struct dem_start_overlap *);

/* Collective. Backups in memory, for the case that the run fails: one now, and one in
   dem_advance whenever `steps` steps have passed since the last (0: none). A state with a number
   that is not finite is not copied; the last backup stays. Has no influence on the run. */
int dem_backup_every(struct dem *, int64_t steps);

/* Collective. Go back to the last backup, of time *time [s], also after a failed dem_advance;
   then query, save or advance. Averages keep what they have sampled. */
int dem_restore(struct dem *, double *time);

/* 1 unless the last dem_advance failed on one rank only. Failures of the physics (a number that
   is not finite, too much overlap, a lost particle) are common to all ranks: dem_lost,
   dem_restore and what follows still work. */
int dem_ranks_agree(const struct dem *);

/* ---- tables of a run ------------------------------------------------------------------------- */

/* CSV tables that grow by rows: lost.csv, bonds.csv, flows.csv, walls.csv, energy.csv, and others of
   the caller; docs/output.md describes their columns. The first line has the names of the columns;
   the file is made with the first row, and effects.csv beside it names the effects of the run. What
   follows is called on one rank, unless it says collective. */

/* Name a table, for example "lost.csv" in a folder. Touches no file. The calls below refuse a folder
   whose path is too long. */
void dem_table_name(struct dem_table *, const char *folder, const char *file, double start);

/* Before the first row: what an earlier run may have left. The file is removed if the run starts at
   0 or time_column is negative; else the rows with a time after the start are, the number in
   time_column (from 0). */
int dem_table_begin(const struct dem_table *, const struct dem *, int time_column);

/* Append lines, each with its line's end. A new table gets the line `columns`. The folder is made,
   but not those around it. DEM_ERROR_FILE when not all could be written. */
int dem_table_append(const struct dem_table *, const struct dem *, const char *columns,
                     const char *rows);

/* Rows of lost.csv: n losses of dem_lost, with `offset` [s] added to their times; patch[k] is added
   to the cause, unless patch is NULL. */
int dem_table_add_losses(const struct dem_table *, const struct dem *, int64_t n,
                         const struct dem_loss *, double offset, const char *const *patch);

/* Rows of bonds.csv: n bonds of dem_broken_bonds, with `offset` [s] added to their times. */
int dem_table_add_bonds(const struct dem_table *, const struct dem *, int64_t n,
                        const struct dem_broken_bond *, double offset);

/* Collective. Set the sums to their values at the time `now` [s], without rows. */
int dem_flow_sums_set(struct dem_flow_sums *, struct dem *, double now);

/* Collective. Rows of flows.csv: a row for each stream and outlet with its rates since `last`,
   which becomes now. Written where table is not NULL. */
int dem_table_add_flows(const struct dem_table *, struct dem *, double now,
                        struct dem_flow_sums *last);

/* Collective. Rows of walls.csv: mean forces and torques since `elapsed` [s], when the sums were
   reset, and present ones; the sums are reset. Written where table is not NULL. */
int dem_table_add_walls(const struct dem_table *, struct dem *, double now, double elapsed);

/* Row of energy.csv with n items of dem_energy. */
int dem_table_add_energy(const struct dem_table *, const struct dem *, double now, double since,
                         int n, const struct dem_energy_item *);

#ifdef __cplusplus
}
#endif
#endif
