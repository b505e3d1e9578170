/*
 * totals.h -- totals over all particles and contact rows, with the same bits on any number of
 * ranks.
 *
 * Errors of MPI are recorded in the decomposition (ranks/collect.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_types.h"
#include "core/sum.h"
#include "ranks/dem_state.h"

/* Collective. Reduce `count` exact sums over all ranks and round each of them once to `value`. */
void dem_totals_reduce_sums(const struct dem_state *, struct dem_sum *sum, int count,
                            double *value);

/* Collective. The maximum of each of `count` numbers over all ranks. */
void dem_totals_reduce_max(const struct dem_state *, double *value, int count);

/* Collective. Particles, energy, momentum, touching contacts. Resets the largest overlap of the
   limits check. */
void dem_totals_tally(struct dem_state *, struct dem_totals *);

/* Contact rows of this rank that touched in the last sweep, each counted by the owner of its lower
   id. */
int64_t dem_totals_touching(const struct dem_state *);

/* Collective. Sum of C s of a scalar s with the capacity C over all particles (laws/scalar.h). */
double dem_totals_scalar(const struct dem_state *, int scalar);

/* Collective. Number of particles with more kinetic energy than `energy` [J]; a clump is one. */
int64_t dem_totals_moving(const struct dem_state *, double energy);

/* Solid volume [m3] of a particle; of a sphere of a clump its share of the union of them. */
double dem_totals_volume(const struct dem_state *, const struct dem_particle *);

/* Collective. Largest speed of a particle [m/s]. */
double dem_totals_max_speed(const struct dem_state *);

/* Collective. Extent [m] of the centres of all particles that are not frozen along a vector; 0
   without any. */
double dem_totals_extent(const struct dem_state *, const double along[3]);

/* Collective. Force [N] and torque about the origin [N m] of the particles on a wall in the last
   step. */
void dem_totals_wall_force(const struct dem_state *, int wall, double force[3], double torque[3]);

/* Collective. Impulse [N s] on a wall and its moment about the origin [N m s] since the wall
   statistics were started. */
void dem_totals_wall_impulse(const struct dem_state *, int wall, double impulse[3],
                             double twist[3]);

/* Collective. Work [J] of a wall on particles since then. */
double dem_totals_wall_work(const struct dem_state *, int wall);

/* Collective. Hash of ids, positions, velocities, spins and of the whole contact history. */
uint64_t dem_totals_fingerprint(const struct dem_state *);

/* The largest overlaps between particles and with walls at the present positions. For checks of the
   input, after the lists have been built. Of this rank; collective, of all ranks. */
struct dem_overlap
{
    double fraction;      /* 1  of the smaller diameter; 0: none */
    int64_t id, partner;  /* of the particle; of the other one, or the number of the wall */
    double x[3];          /* m  of the particle */
};

/* flags: of contacts of particles with one of these flags only; 0: of all. `walls`: 1 for each wall that
   counts; NULL: all count. */
void dem_totals_max_overlap(struct dem_state *, unsigned flags, const char *walls, struct dem_overlap *pair,
                            struct dem_overlap *wall);
int dem_totals_max_overlap_over_ranks(struct dem_state *, const char *walls, struct dem_overlap *pair,
                                      struct dem_overlap *wall);

/* Collective. Sauter mean diameter of all particles, sum d^3/sum d^2 [m]; 0 without particles. */
double dem_totals_sauter_diameter(const struct dem_state *);

/* Collective. 1 if a rank has a driven particle. */
int dem_totals_any_driven(const struct dem_state *);

/* Collective. 1 if a rank has a particle that forces move. */
int dem_totals_any_free(const struct dem_state *);
