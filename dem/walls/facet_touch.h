/*
 * facet_touch.h -- the contact of a particle with a facet. Devices compile it, too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "walls/facet.h"

/* Points nearer than this fraction of the radius are one point: far above round-off, far below any
   overlap that matters. */
#define DEM_SAME_POINT 1e-7

struct dem_wall_touch
{
    double point[3], normal[3], distance;  /* m, unit vector to the particle, m;
                                              DBL_MAX when dropped or without a row */
    int drop;                              /* 1: another facet has this contact */
    double exponent;                       /* m of its normal law */
    uint32_t row;                          /* its contact row, or DEM_ROW_NONE (wall_rows.h) */
    uint32_t surface;                      /* scratch of facet_springs.h */
};

/* The contact with a facet of triangles that a particle at x sees at `from`, both in the wall's frame,
   from the nearest point, `away` from there to the particle, and the distance, which the contact
   has. Inside a facet it has the plane's own normal, free of the round-off at edges. */
DEM_MATH void dem_facet_touch_triangles(const struct dem_facet *r, const double from[3],
                                        const double x[3], const double away[3], double radius,
                                        struct dem_wall_touch *t)
{
    double apart[3], point[3], normal[3];
    const double distance = dem_facet_touch(r, from, x, point, normal);
    int inside;

    for (int k = 0; k < 3; k++)
    {
        apart[k] = away[k] - distance*normal[k];
    }
    inside = (dem_vec_norm(apart) < DEM_SAME_POINT*radius && !r->bent) || t->distance == 0.0;
    for (int k = 0; k < 3; k++)
    {
        t->normal[k] = inside ? normal[k] : away[k]/t->distance;
        t->point[k] = inside ? point[k] : t->point[k];
    }
    t->distance = inside ? distance : t->distance;
}
