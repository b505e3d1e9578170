/*
 * orientation.h -- orientation of each sphere as a unit quaternion; only in runs that request it.
 *
 * q = (cos(a/2), n sin(a/2)) is the rotation by the angle a about the unit vector n from the
 * initial to the present orientation: a mark that was at m from the centre is now at q m q*.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/particles.h"

/* Set the orientation of particles that have none yet (all zero) to (1 0 0 0). */
void dem_orientation_begin(struct dem_particles *);

/* Rotate owned particles by their present spins over a step of dt [s]. Nothing without the
   column. */
void dem_orientation_turn(struct dem_particles *, double dt);
