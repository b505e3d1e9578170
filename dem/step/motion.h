/*
 * motion.h -- the drift of a leapfrog step in kick-drift form; the kicks are in sweep_bodies.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_MOTION_H
#define DEM_STEP_MOTION_H

#include "state/particles.h"

/* x += dt v for owned particles, in whole multiples by dem_domain.round. Returns the largest speed [m/s]; a not-a-number comes out as infinite. */
double dem_motion_drift(struct dem_particles *, double dt, const double round[4]);

#endif
