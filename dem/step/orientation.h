/*
 * orientation.h -- how each sphere has turned since the start, as a unit quaternion; only in runs that ask for it.
 *
 * q = (cos(a/2), n sin(a/2)) is the rotation by the angle a about the unit vector n that brings the sphere from where it was
 * at the start to how it is now: a mark at m from the centre then is at q m q* now.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_ORIENTATION_H
#define DEM_STEP_ORIENTATION_H

#include "state/particles.h"

/* Whoever has none yet has not turned: (1 0 0 0). */
void dem_orientation_begin(struct dem_particles *);

/* A step of dt [s] with the spins of now, for owned particles. */
void dem_orientation_turn(struct dem_particles *, double dt);

#endif
