/*
 * drift.h -- the drift of a leapfrog step in kick-drift form, x += dt v. The kicks are in
 * sweep_bodies.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_DRIFT_H
#define DEM_STEP_DRIFT_H

#include "model/particles.h"

struct dem_drift_speeds    /* speeds so far, in four lanes; start with zeros */
{
    double max_square[4], invalid[4];  /* m2/s2: largest square of a speed;
                                          0, or not a number if one was */
};

/* Drift n particles over dt [s]. Adding and subtracting dem_domain.round rounds each displacement
   to a multiple of the domain's unit of length. Their speeds are added to the last argument. */
void dem_drift_particles(struct dem_particle *, size_t n, double dt, const double round[4],
                         struct dem_drift_speeds *);

/* The largest speed [m/s]; infinite if a speed was not a number. */
double dem_drift_max_speed(const struct dem_drift_speeds *);

#endif
