/*
 * wall_corners.h -- which corners of triangles coincide, images along periodic axes included.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "walls/walls.h"

/* a corner of a triangle */
struct dem_vertex
{
    size_t label;                 /* the same for corners that coincide, or whose images do */
    int16_t period[3];            /* in which it is, so that images can be told apart */
};

/* Order of two corners by their coordinates, for sorting. */
int dem_walls_compare_corners(const void *, const void *);

/* vertex: one for each corner, 3 a triangle. tolerance [m]: corners that near are one. */
int dem_walls_weld_corners(const struct dem_walls *, double tolerance, struct dem_vertex *vertex);
