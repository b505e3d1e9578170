/*
 * wall_extent.h -- the extent along a coordinate axis that walls reach in their whole motion.
 *
 * The extent is infinite for a wall moved by force, except on a hinge. For several motions with a rotation about another
 * axis a box around each point is turned by each rotation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "walls/walls.h"

/* Displacements along an axis that a motion without rotation reaches [m]. */
void dem_motion_travel(const struct dem_motion *, int axis, double range[2]);

/* The extent [m] along an axis that a point of a reference frame, or a triangle reaches; frame -1: at rest. */
void dem_walls_swept_point(const struct dem_walls *, int frame, const double x[3], int axis, double extent[2]);
void dem_walls_swept_extent(const struct dem_walls *, const struct dem_triangle *, int axis, double extent[2]);
