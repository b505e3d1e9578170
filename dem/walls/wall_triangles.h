/*
 * wall_triangles.h -- the triangles of walls before they are joined to facets.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "walls/walls.h"

/* The normal with twice the area as its length, which is returned [m2]. */
double dem_triangle_area_vector(const struct dem_triangle *, double normal[3]);

/* 1 when the height of a triangle is at most `height` [m]. It can be dropped: its neighbours have
   its edges too. */
int dem_triangle_is_flat(const struct dem_triangle *, double height);

/* Sort the triangles; drop duplicates and flat ones, and count both. */
int dem_walls_drop_flat(struct dem_walls *, double height);

/* Area and centroid of the triangles of each wall. */
void dem_walls_measure(struct dem_walls *);

/* Which frames have walls of triangles, and their boxes. */
void dem_walls_find_boxes(struct dem_walls *);
