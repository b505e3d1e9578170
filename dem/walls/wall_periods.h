/*
 * wall_periods.h -- walls in a periodic domain: images of triangles, and which walls are refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/domain.h"
#include "walls/walls.h"

/* Before walls are finished: their triangles get periodic images. `reach` [m]: a particle is compared
   with what is that near. */
void dem_domain_make_walls_periodic(const struct dem_domain *, double reach, struct dem_walls *);

/* DEM_ERROR_INPUT for a wall that comes nearer than a particle's radius [m] to a periodic face and
   that has no images there, anywhere in its motion: a plane, cylinder or sphere that does not run
   straight through the face; triangles that rotate about another axis; a surface that is longer than
   the period and does not run straight through it. */
int dem_domain_check_walls(const struct dem_domain *, const struct dem_walls *, double radius);
