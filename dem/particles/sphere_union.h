/*
 * sphere_union.h -- volume, centre and second moments of a union of spheres.
 *
 * They are sums in closed form where no two spheres overlap; else integrals over columns along
 * z, the midpoints of a grid on the x-y face of the bounding box: exact along z, and to 1e-5 across,
 * where the error is 0.08 (h/r)^2 for spheres of radius r. The width of a column is, along x and y,
 *
 *   h = the smaller of 1/1024 of the box and the larger of sqrt(sum r^3/sum r)/150 and
 *       sqrt(pi sum r^2/8e6), with which at most 8e6 columns meet a sphere                     [m]
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <stddef.h>

struct dem_union_moments
{
    double origin[3];       /* m   middle of the bounding box */
    double volume;          /* m3 */
    double first[3];        /* m4  integral of x - origin */
    double second[3][3];    /* m5  integral of (x - origin)(x - origin)^T */
};

/* n spheres, at most DEM_CLUMP_SPHERES: x, y, z and radius [m]. */
void dem_sphere_union(size_t n, const double (*sphere)[4], struct dem_union_moments *);
