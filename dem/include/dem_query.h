/*
 * dem_query.h -- what a run tells between two advances: totals and energies, lost particles and
 * flows, bonds, walls, particles and their scalars. Structs are in dem_types.h, in sections of the
 * same titles; units, ownership and status codes as in dem.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_QUERY_H
#define DEM_QUERY_H

#include "dem.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- totals, profile, energy ----------------------------------------------------------------- */

/* Collective. Sums over all particles and contacts; resets the largest overlap. */
int dem_totals(struct dem *, struct dem_totals *);

/* Collective, between two advances. The cost of the run since dem_start. Has no influence on the
   run. */
int dem_profile(struct dem *, struct dem_profile *);

/* Collective. The profile as text, the same on all ranks, valid until the next call or dem_free. */
int dem_profile_text(struct dem *, const char **text);

/* Collective. The energy balance: kinetic and elastic energies are the present ones, all other
   terms are sums since the time *since [s]. Terms of all ranks, in the same order at each call;
   valid until the next. An error in a run that keeps none. */
int dem_energy(struct dem *, double *since, int *n, const struct dem_energy_item **item);

/* Collective. The number of particles with more kinetic energy than `energy` [J]. The rotation of
   clumps counts, but not of spheres: they may spin for ever without resistance to twisting. */
int dem_count_moving(struct dem *, double energy, int64_t *n);

/* Rest, as time/untilQuiet defines it (dem_case_read_quiet). dem_quiet_check: an error when the
   scene has no gravity to compare with. dem_quiet_tests: the number of tests in an interval [s].
   dem_quiet_test, collective, does nothing unless `wanted`: test with the present totals, set
   `reached`. */
int dem_quiet_check(const struct dem *, const struct dem_quiet *);
int64_t dem_quiet_tests(const struct dem *, const struct dem_quiet *, double interval);
int dem_quiet_test(struct dem *, struct dem_quiet *, const struct dem_totals *);

/* Collective. A 64-bit hash of particles and contact history, the same on any number of ranks. */
int dem_hash(struct dem *, uint64_t *hash);

/* ---- device ---------------------------------------------------------------------------------- */

/* What makes the steps, where the scene has an entry `device`: name, platform and driver of the device;
   or a sentence why the CPU makes them all, with the same bits. "" without the entry. */
const char *dem_device(const struct dem *);

/* Steps that the device has made so far, in so many parts between which the state was copied; steps
   that it gave up for the CPU, because of an event. Zeros without a device. */
void dem_device_steps(const struct dem *, int64_t *made, int64_t *parts, int64_t *repeated);

/* Memory [byte] that the device needs for the particles as a dense bed; 0 without a device. */
double dem_device_bytes(const struct dem *);

/* The devices of this machine as lines of text, or a sentence why there are none. Needs no run;
   valid until the next call of this thread. */
const char *dem_devices_text(void);

/* ---- lost particles, streams and outlets ----------------------------------------------------- */

/* Collective. Losses of all ranks since the last call, sorted by time and id; the same list on
   every rank and on any number of ranks. Valid until the next call.
   Losses and broken bonds are recorded in any case, with 288 and 64 bytes each, until dem_lost
   and dem_broken_bonds return them, also across dem_restore: a long run calls both now and then. */
int dem_lost(struct dem *, int64_t *n, const struct dem_loss **);

/* Streams, outlets, and the domain if particles may leave it, in this order; none in a scene
   without streams and outlets. The same on all ranks; valid until the next call. */
int dem_flows(struct dem *, int *n, const struct dem_flow **);

/* The residence times of row k of dem_flows; NULL where its outlet has no entry `residence`. Valid until
   the next advance. */
const struct dem_residence *dem_residence(const struct dem *, int k);

/* ---- stages ---------------------------------------------------------------------------------- */

/* The name of stage k of the scene, from 0; NULL behind the last. *begin: when it began [s], infinite if it
   has not; *why: what has ended the stage before it, "" where it is not known. */
const char *dem_run_stage(const struct dem *, int k, double *begin, const char **why);
/* A line for each stage that has not begun, with what the one before waits for and what waits for it; "" where
   all have begun. Valid until the next call of this thread. */
int dem_stages_left_text(const struct dem *, const char **text);
int dem_stages_over(const struct dem *);  /* 1: the last stage has ended */

/* ---- a cell that deforms ---------------------------------------------------------------------- */

/* Collective. The scene's domain/cell, with the contacts of the last step; none after a load before the
   first step. An error in a scene without a cell. */
int dem_cell(struct dem *, struct dem_cell_now *);
int dem_has_cell(const struct dem *);  /* 1: the scene has one */

/* ---- bonds ----------------------------------------------------------------------------------- */

int dem_has_bonds(const struct dem *);  /* 1 when an effect of the scene makes bonds */

/* The bonds whose lower particle this rank owns, as of the last step; none after a load or
   restore, before the first step. Valid until the next call. */
int dem_bonds(struct dem *, int64_t *n, const struct dem_bond **);

/* Collective. The bonds of all ranks that broke since the last call, as in dem_lost. */
int dem_broken_bonds(struct dem *, int64_t *n, const struct dem_broken_bond **);
const char *dem_broken_bond_cause(int cause);  /* "tension", "shear", "distance" */

/* ---- walls ----------------------------------------------------------------------------------- */

/* Walls are numbered from 0 to dem_wall_count - 1. dem_wall_name: "" for another
   number. dem_wall_load, collective: the present force of particles on a wall [N], and its torque
   about the origin [N m]. */
int dem_wall_count(const struct dem *);
const char *dem_wall_name(const struct dem *, int wall);
int dem_wall_load(struct dem *, int wall, double force[3], double torque[3]);

/* Impulse of particles on a wall [N s] and its moment about the origin [N m s] since the last
   dem_wall_impulse_reset, which starts or resets the sums of all walls. Divided by the time since,
   they are mean force and torque. dem_wall_impulse is collective. */
int dem_wall_impulse_reset(struct dem *);
int dem_wall_impulse(struct dem *, int wall, double impulse[3], double angular_impulse[3]);

/* Collective. Work [J] of a wall on the particles since then; 0 for a wall at rest. The axis [unit],
   through `origin` [m], about which a wall or its surface turns: returns 0, and the z axis, for a wall
   without one that is fixed in space. */
int dem_wall_work(struct dem *, int wall, double *work);
int dem_wall_axis(const struct dem *, int wall, double origin[3], double axis[3]);

/* Number of triangles of a wall, and whether it moves; zeros for a number that no wall has. */
void dem_wall_info(const struct dem *, int wall, struct dem_wall_info *);

/* Where a wall is; the identity for a number that no wall has. */
void dem_wall_position(const struct dem *, int wall, struct dem_wall_position *);

/* Set the load of a wall that is moved by force, from now on and in place of the scene's: force [N] of a
   free wall, torque [N m] of a hinge in load[0], force [N] or pressure [Pa] of a servo in load[0]. All
   ranks give the same. NULL: the scene's again. Snapshots hold it: after a restart it acts until the program
   sets another. dem_restore brings back the load at the time of the backup. */
int dem_wall_set_load(struct dem *, const char *name, const double load[3]);

/* Collective. Write the present corners of a wall's triangles [m], 9 numbers each, into an array of
   9*dem_wall_info.triangles numbers of the first rank; other ranks may give NULL. The order is
   always the same. */
int dem_wall_corners(struct dem *, int wall, double *corners);

/* 1 when the wear of a wall is summed. dem_wall_wear, collective: the volume [m3] worn off each of its
   triangles since the start, in the order of dem_wall_corners, into an array of the first
   rank; other ranks may give NULL. */
int dem_wall_wears(const struct dem *, int wall);
int dem_wall_wear(struct dem *, int wall, double *volume);

/* ---- particles ------------------------------------------------------------------------------- */

/* The particles that this rank owns: pointers into the library's arrays, for reading. */
void dem_view(const struct dem *, struct dem_view *);

/* For languages whose arrays may outlive what they show: the arrays of dem_view stay as they are and
   belong to the caller from now on, who frees each with dem_view_free; the run goes on with
   copies. */
int dem_view_leave(struct dem *, struct dem_view_arrays *);
void dem_view_free(void *array);    /* NULL is allowed */

/* Contact stress times volume [J] of each particle of the view: xx yy zz xy yz zx of the sum of
   force times branch vector over its contacts, tension positive (records/virial.h). Sums over a
   region divided by its volume are the contact stress. `virial` has 6 numbers a particle; all are 0
   after a load or restore, before the first step. An error in a run that does not keep the forces
   of all contacts (dem_case_enable_virial). */
int dem_virial(struct dem *, double *virial);
const char *dem_material_name(const struct dem *, int material);  /* "" for an unknown number */

/* The value of a particle in a column with a stride [byte]. */
static inline const double *dem_at(const double *column, size_t stride, size_t particle)
{
    return (const double *)(const void *)((const char *)column + stride*particle);
}

/* ---- particle scalars ------------------------------------------------------------------------ */

/* The number of particle scalars that the effects of the scene declare
   (temperature, ...), and what is known of number k: zeros and empty texts for another number.
   dem_scalar_index: the number of one, or -1. */
int dem_scalar_count(const struct dem *);
void dem_scalar_info(const struct dem *, int k, struct dem_scalar_info *);
int dem_scalar_index(const struct dem *, const char *name);

/* The values of scalar k of the owned particles, in the order of dem_view; NULL for another number.
   Valid until the next collective call. The energy balance does not see what is written here; use
   dem_set_scalar. All spheres of a clump have one temperature: the one of its smallest id counts. */
double *dem_scalar(struct dem *, int k);

/* Collective. Write the values of scalar k of the owned particles, in that order, between two
   advances; the energy balance has the heat that this supplies as its item `edited`. After an error
   all values are as before. */
int dem_set_scalar(struct dem *, int k, const double *values);

/* Collective. The sum of C s over all particles, of scalar k with the capacity C: of the
   temperature, the heat of the particles above 0 K [J]. */
int dem_scalar_total(struct dem *, int k, double *total);

/* ---- effects of the scene -------------------------------------------------------------------- */

/* The names of all active effects, in the order of their stages, and of fluid effects only. Valid
   until the case or the run is freed. */
const char *dem_effect_names(const struct dem *);
const char *dem_fluid_effect_names(const struct dem *);

/* Sets g to the uniform acceleration of all particles [m/s2], zero without one. Returns 1 if an
   effect of the scene gives it, else 0. */
int dem_gravity_acceleration(const struct dem *, double g[3]);

#ifdef __cplusplus
}
#endif
#endif
