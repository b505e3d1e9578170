/*
 * wall_path.h -- does a straight path pass through a wall?
 *
 * A sphere that lies clear of all walls may have come from the other side of a surface with two
 * sides, or through a solid cylinder or sphere. Walls are taken at their present poses.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/domain.h"
#include "walls/wall_search.h"

/* passes: 1 when the straight path of a centre between two points [m] goes through a triangle, or
   through a cylinder or sphere that has the particles outside. Planes, and cylinders and spheres
   with the particles inside, are convex: the two ends tell (dem_wall_search_is_clear). The path may
   cross periodic faces: it is wrapped in pieces of `radius` [m]. The wall neighbors found before are
   kept. */
int dem_wall_path_passes(struct dem_wall_search *, const struct dem_walls *,
                         const struct dem_domain *, double radius, const double from[3],
                         const double to[3], int *passes);
