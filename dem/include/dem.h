/*
 * dem.h -- public interface of Suna's discrete element library: describe a case, run it, save.
 *
 * A case is described and then started; both are types of their own, so that calls out of order do
 * not compile:
 *
 *     struct dem_case *c;
 *     struct dem *d;
 *
 *     dem_case_create(&c, comm);
 *     dem_case_scene_file(c, "drop.dem");      materials, effects, walls, particles, as text in
 *     dem_case_set(c, "time/step", "1e-6");    OpenFOAM's dictionary syntax
 *     dem_start(&c, &d);                       consumes the case: c is NULL from then on
 *     dem_advance(d, 0.1);
 *     dem_save(d, "drop.snapshot");
 *     dem_free(d);
 *
 * Other headers, by subject: dem_query.h for particles, walls, bonds and totals of a run, dem_fluid.h
 * for a program that solves a fluid, dem_tables.h for files that programs write, dem_plan.h for
 * plan, warnings and the list of effects. Status codes and structs are in dem_types.h.
 *
 * Return values: functions that can fail return DEM_OK (0) or another status (DEM_ERROR_...);
 * dem_error_text() then gives one sentence with the thing, the value, the limit and the cure.
 * Functions that return no status may be called with any number: for a number out of range,
 * numbers and counts are 0, texts are empty and pointers to data are NULL, unless the comment says
 * otherwise.
 *
 * Collective: such a function is called by all ranks of the communicator together and fails on all
 * of them together.
 *
 * Ownership: arguments are copied, unless the comment says otherwise. Arrays and texts that the
 * library returns belong to it; the comment says how long they are valid. Nothing is to be freed
 * but the case that was not started, and the run.
 *
 * Units are SI; vectors are x, y, z. "Contiguous, 3 each" is an array x0 y0 z0 x1 y1 z1 ...
 *
 * The library never prints or exits, and never aborts by itself.
 *
 * MPI: with MPI_COMM_NULL no MPI call is made. Otherwise the library works on its own duplicate of
 * the communicator, on which it sets MPI_ERRORS_RETURN: an error of a call on it is returned as
 * DEM_ERROR_MPI, with MPI's text, and not handled by the error handler of the caller's
 * communicator. There are three exceptions: MPI_Comm_dup in dem_case_create uses the handler of the
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
   number, also in the name of the shared library, changes when a struct or a function of a public
   header changes. */
#define DEM_VERSION "0.1.0"

struct dem_case;    /* what will run */
struct dem;         /* a run */

/* DEM_VERSION of the library that is loaded. */
const char *dem_version(void);

/* The message of the last error of this thread; empty before the first. Valid until the next
   error. Never NULL. */
const char *dem_error_text(void);

/* Make the error for an unknown word, e.g. `what` = "option": always fails, with a message that
   lists the n known words, the most similar first. */
int dem_did_you_mean_error(const char *what, const char *word, const char *const *known, int n);

/* ---- case ------------------------------------------------------------------------------------ */

/* Collective. Create an empty case. It ends in dem_start, or in dem_case_free. The communicator is
   duplicated; MPI_COMM_NULL runs on one rank without MPI. On failure the pointer is NULL. */
int dem_case_create(struct dem_case **, MPI_Comm);

/* The same for other languages: the communicator's Fortran handle; -1 for MPI_COMM_NULL. */
int dem_case_create_fortran(struct dem_case **, int comm);
void dem_case_free(struct dem_case *);  /* collective; NULL is allowed */

/* Read a scene, once, from a file or from a text; `name` stands for the file name in messages. */
int dem_case_scene_file(struct dem_case *, const char *path);
int dem_case_scene_text(struct dem_case *, const char *text, const char *name);

/* Override or add one entry of the scene: dem_case_set(c, "effects/dry/restitution", "0.9"). */
int dem_case_set(struct dem_case *, const char *path, const char *value);

/* Remove one entry or group of the scene: dem_case_remove(c, "walls/gate"). *removed: 1 when it was
   there. */
int dem_case_remove(struct dem_case *, const char *path, int *removed);

/* Remove an effect from the entries `effects` and `pairs` of the scene. An error when the scene
   does not have it. */
int dem_case_remove_effect(struct dem_case *, const char *effect);

/* Collective. Add a wall of n triangles: 9 numbers each [m], three corners. Ranks may give all
   triangles or each its own ones; a triangle given by two ranks counts once. No other wall may
   have this name; the material is one of the scene. */
int dem_case_add_wall(struct dem_case *, const char *name, const char *material, int64_t n,
                      const double *triangles);

/* Collective. The present corners [m] of a wall of dem_case_add_wall, which was given the original
   mesh: the same number of triangles in the same order as this rank added. Contacts are identified
   by the original surface, so a restarted run adds the same one. */
int dem_case_move_wall(struct dem_case *, const char *name, int64_t n, const double *triangles);

/* Collective. The closed surface of a mesh (zone 0), or of one of its zones of cells, of this name:
   n triangles of this rank, 9 numbers each [m], corners counterclockwise as seen from outside.
   Groups of `insert` name it by `inside mesh` or `zone NAME`. */
int dem_case_add_region(struct dem_case *, const char *name, int zone, int64_t n,
                        const double *triangles);

/* Add particles besides the scene's own. Every rank gives the same list. */
int dem_case_add_particles(struct dem_case *, int64_t n, const struct dem_new_particle *);

/* Particles of this material may get diameters from `min` to `max` [m] in dem_add_particles. */
int dem_case_allow_diameters(struct dem_case *, const char *material, double min, double max);

/* Continue from a snapshot, which is read in dem_start. The scene may be an edited one: groups of
   `insert` that the snapshot does not have are inserted, walls go on from where they stood, and
   dem_warnings names every difference. */
int dem_case_load(struct dem_case *, const char *path);

/* The same for a state that another run has made, as the scene's entry `start` does, whose other
   entries hold if the scene has one: dem_start refuses an overlap with a wall of more than 0.05 of
   a diameter that is also more than twice the largest between particles (dem_start_overlap). */
int dem_case_start_from(struct dem_case *, const char *path);

/* What only some runs need. The energy balance, for dem_energy. The orientation of each particle, a
   unit quaternion (cos(a/2), n sin(a/2)): the rotation by the angle a about the axis n since the
   start, or since the first run that has integrated it (snapshots hold it); no effect depends on
   it. The forces of all contacts, for dem_virial: 64 bytes a candidate contact, 96 with moments;
   some 180 a particle of a dense bed. */
int dem_case_enable_energy(struct dem_case *);
int dem_case_enable_orientation(struct dem_case *);
int dem_case_enable_virial(struct dem_case *);

/* The entry time/untilQuiet, for dem_quiet_test; without it the defaults, with `wanted` 0. */
int dem_case_read_quiet(const struct dem_case *, struct dem_quiet *);

/* Collective. Read the scene and check all that can be checked before particles are placed, which
   may take long. Entries that nothing has read are refused. From then on the case is not changed
   any more. After an error it can only be freed. */
int dem_case_check(struct dem_case *);

/* What dem_case_check has found, for the calls below that take const struct dem *: names and
   settings of effects, walls and scalars, gravity, and without a snapshot the time step. There are
   no particles yet. NULL before, and after an error. Valid until dem_start or dem_case_free. */
const struct dem *dem_case_checked(const struct dem_case *);

/* Collective. Start: check, unless dem_case_check has done it, freeze the laws, insert the
   particles or load the snapshot, distribute particles to ranks. Takes long for dense random
   packings. The case is gone and its pointer NULL, also after an error; the pointer to the run is
   then NULL, too. */
int dem_start(struct dem_case **, struct dem **);

void dem_free(struct dem *);  /* collective; NULL is allowed */

/* ---- entries of the scene that belong to the program ----------------------------------------- */

/* The scene's dictionary (functions in input/dictionary.h). Read entries of the program before
   dem_case_check, which refuses those that nothing has read. NULL before a scene is read; valid
   until the case or the run is freed. */
struct dem_dict;
const struct dem_dict *dem_case_dict(const struct dem_case *);
const struct dem_dict *dem_scene_dict(const struct dem *);

/* The same without that header, by path ("time/end"; "walls/jar/motion/0" for the first of a list of
   dictionaries), for other languages. dem_scene_value: the text of a value, its words separated by
   blanks, valid until the next call of this thread; NULL for a group, and where there is no entry.
   dem_scene_name: the name of entry k of a group, from 0 ("" is the whole scene); NULL behind the
   last. dem_scene_skip: nothing will read this entry or group. The first and the last count as
   reading it. */
const char *dem_scene_value(const struct dem_dict *, const char *path);
const char *dem_scene_name(const struct dem_dict *, const char *path, int k);
void dem_scene_skip(const struct dem_dict *, const char *path);

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

/* The largest *asked of all ranks after the last step of the last dem_advance, whether it ended there or not: for
   programs that advance one step at a time. */
int dem_stop_requested(const struct dem *);

/* From now on dem_advance calls `report` on this rank, at most once in `seconds` of the clock, with
   `self`, the simulated time [s] and the number of steps made so far. The only calls of the
   library that it may make are dem_stop_file_look and dem_keep_signals. NULL ends it. */
void dem_set_progress(struct dem *, double seconds,
                      void (*report)(void *self, double time, int64_t steps), void *self);

/* From now on dem_advance calls `add` on this rank in each step: after the particles have moved and
   before contact forces are computed, at the time of the positions, with velocities half a step behind
   them; and before its first half kick, with both at one time. It adds force [N] and torque [N m],
   3 each in the order of the view, 0 when it is called, which act in the kick of this step; forces in
   the view are contact forces of the step before. The result must depend on the particle, not on
   rank or index, for the same bits on any ranks. It may call only dem_at of the library. Forces on
   frozen particles have no effect. A force on a sphere of a clump acts on the clump, at the centre of the
   sphere. NULL ends it. Refused in coupled runs; with it the CPU makes the steps. */
int dem_set_force(struct dem *,
                  void (*add)(void *self, double time, const struct dem_view *, double *force,
                              double *torque), void *self);

/* The longest stable step and the step in use. Zeros where a snapshot has not been read yet. */
struct dem_step_limit dem_step_limit(const struct dem *);

/* Collective. Move a wall of dem_case_add_wall, e.g. with a moving mesh, in the same order: its
   corners [m] at the end of the next dem_advance; they move linearly in time until then. A wall for
   which it is not called stays at rest. */
int dem_wall_move(struct dem *, const char *name, int64_t n, const double *triangles);

/* ---- change a run between two advances ------------------------------------------------------- */

/* Collective; each rank gives the same list. Add, remove or change particles between two advances. The
   energy balance has what that supplies as its item `edited`. After an error the run is as before,
   unless memory has run out. Refused in coupled runs, and after an advance that was stopped, until
   another step has been made.

   dem_add_particles: an id below 0 becomes the next free one; another one has to be above all ids
   that the run has had. `id`, if not NULL, gets the ids. The run has a particle of the same material
   that is not smaller and one that is not larger: the time step and the lists follow from these
   (dem_case_allow_diameters). New particles touch nothing, or overlap by less than
   time/maxStartOverlap.
   dem_remove_particles: contacts and bonds with the particles end.
   dem_set_particles: n numbers or vectors for n different ids; NULL leaves a quantity as it is. A
   particle that is moved keeps the history of contacts that it still has. One that is frozen
   comes to rest, or has the velocity and spin that are given with it.

   Clumps are added, removed and moved as a whole. dem_add_clumps: the scene needs a group or stream of clumps of this
   material that are not larger, because the time step follows from them, and its spheres must have diameters that
   occur there. The spheres get consecutive ids; `id` is the first one. dem_remove_particles needs the ids of all
   spheres of a clump. dem_set_particles moves a clump by the id of its first sphere; position and velocity are those
   of its centre of mass. Particle scalars are set sphere by sphere; all spheres of a clump get the same
   temperature. */
struct dem_particle_changes
{
    const double *position, *velocity, *spin;  /* m, m/s, 1/s  3 each */
    const int *frozen;                         /* 0 or 1 */
    const double *value;                       /* of the particle scalar of this number */
    int scalar;
};
struct dem_new_clump
{
    double position[3], velocity[3], spin[3];  /* m, m/s, 1/s  of its centre of mass; about it */
    double orientation[4];                     /* unit quaternion that turns the shape of the scene */
    int64_t id;                                /* of its first sphere; below 0: the next free id */
    const char *shape, *material;              /* names in the scene */
    int frozen;
};
int dem_add_particles(struct dem *, int64_t n, const struct dem_new_particle *, int64_t *id);
int dem_add_clumps(struct dem *, int64_t n, const struct dem_new_clump *, int64_t *id);
int dem_remove_particles(struct dem *, int64_t n, const int64_t *id);
int dem_set_particles(struct dem *, int64_t n, const int64_t *id,
                      const struct dem_particle_changes *);

/* Collective. A run that has been started from a snapshot of `from`, just written, with an edited scene
   takes over what a snapshot does not hold: the sums of the energy balance, if the effects are the
   same, with the change of elastic energy in the item `edited`; impulses on walls
   of the same name; losses and broken bonds that nobody has asked for yet. */
int dem_take_over(struct dem *, struct dem *from);

/* ---- save and restore ------------------------------------------------------------------------ */

/* Collective. Write a snapshot: all ranks write one temporary file, which is verified, flushed to
   disk and renamed, so that a file of that name stays until the new one is complete. A snapshot
   loads on any number of ranks and the run continues with the same bits. After a dem_advance that
   failed it is refused, until dem_restore: a good snapshot stays. */
int dem_save(struct dem *, const char *path);

/* Not collective; needs no simulation. The hash of the state in a snapshot, as dem_hash returns
   it. */
int dem_snapshot_hash(const char *path, uint64_t *hash);

/* The largest overlaps that dem_case_start_from has found at the start; zeros without it. */
void dem_start_overlap(const struct dem *, struct dem_start_overlap *);

/* Collective. Backups in memory, for the case that the run fails: one now, and one in
   dem_advance whenever `steps` steps have passed since the last (0: none). A state with a number
   that is not finite is not copied; the last backup stays. Has no influence on the run. */
int dem_backup_every(struct dem *, int64_t steps);

/* Collective. Go back to the last backup, of time *time [s], also after a failed dem_advance;
   then query, save or advance. Impulses on walls and the energy balance go back, too, and go on but for
   the work of moving walls in the first half step; averages keep what they have sampled. */
int dem_restore(struct dem *, double *time);

/* 1 unless the last dem_advance failed on one rank only. Failures of the physics (a number that
   is not finite, too much overlap, a lost particle) are common to all ranks: dem_lost,
   dem_restore and what follows still work. */
int dem_ranks_agree(const struct dem *);

#ifdef __cplusplus
}
#endif
#endif
