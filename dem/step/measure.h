/*
 * measure.h -- sums over all particles and rows that come out with the same bits on any number of ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_MEASURE_H
#define DEM_STEP_MEASURE_H

#include "dem.h"
#include "base/sum.h"
#include "step/parts.h"

/* Collective. The values of exact sums over all ranks. */
void dem_measure_sums(const struct dem_parts *, struct dem_sum *sum, int count, double *value);

/* Collective. The largest of each number over all ranks. */
void dem_measure_most(const struct dem_parts *, double *value, int count);

/* Collective. Particles, energy, momentum, touching contacts. Resets the watch's largest overlap. */
void dem_measure_tally(struct dem_parts *, struct dem_tally *);

/* Rows of this rank in touch in the last sweep, each counted by the owner of its lower particle. */
int64_t dem_measure_touching(const struct dem_parts *);

/* Collective. Particles with more kinetic energy than this [J]. */
int64_t dem_measure_moving(const struct dem_parts *, double energy);

/* Collective. Force [N] and torque about the origin [N m] of the particles on a wall in the last step. */
void dem_measure_wall(const struct dem_parts *, int wall, double force[3], double torque[3]);

/* Impulse [N s] and its moment [N m s] on a wall since the books were opened. Collective. */
void dem_measure_impulse(const struct dem_parts *, int wall, double impulse[3], double twist[3]);

/* Collective. Fingerprint of ids, positions, velocities, spins and of all remembered contacts. */
uint64_t dem_measure_hash(const struct dem_parts *);

/* The near row with the largest overlap at the present positions: its share of the smaller diameter. For input checks. */
double dem_measure_overlap(struct dem_parts *, int64_t *i, int64_t *j, double x[3]);

/* Collective. Sauter mean diameter of all particles, sum d^3/sum d^2 [m]; 0 without particles. */
double dem_measure_sauter(const struct dem_parts *);

#endif
