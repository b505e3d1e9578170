/*
 * motion.h -- the drift of a leapfrog step in kick-drift form; the kicks are in sweep_bodies.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_MOTION_H
#define DEM_STEP_MOTION_H

#include "state/particles.h"

struct dem_motion_seen                                    /* of speeds; all zero before the first */
{
    double most[4], bad[4];                               /* m2/s2: largest squares; 0 or not a number */
};

/* x += dt v of n particles, in whole multiples by dem_domain.round. */
void dem_motion_drift(struct dem_particle *, size_t n, double dt, const double round[4], struct dem_motion_seen *);

/* The largest speed seen [m/s]; a not-a-number comes out as infinite. */
double dem_motion_fastest(const struct dem_motion_seen *);

#endif
