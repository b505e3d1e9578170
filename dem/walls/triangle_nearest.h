/*
 * triangle_nearest.h -- the point of a triangle, or of an edge, nearest to a position. Devices compile
 * it, too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/vec.h"

/* The point of the edge from a to b nearest to x. Returns the squared distance [m2]. */
static inline double dem_edge_nearest(const double a[3], const double b[3], const double x[3],
                                      double nearest[3])
{
    double ab[3], ax[3], d[3];

    dem_vec_minus(b, a, ab);
    dem_vec_minus(x, a, ax);
    const double along = dem_vec_dot(ax, ab)/dem_vec_dot(ab, ab);
    const double t = along < 0.0 ? 0.0 : along > 1.0 ? 1.0 : along;

    for (int k = 0; k < 3; k++)
    {
        nearest[k] = a[k] + t*ab[k];
        d[k] = x[k] - nearest[k];
    }
    return dem_vec_dot(d, d);
}

/* The same for a triangle with these corners (Voronoi regions). */
static inline double dem_corners_nearest(const double corner[3][3], const double x[3],
                                         double nearest[3])
{
    double ab[3], ac[3], n[3], d[3], best = INFINITY;
    int inside = 1;

    dem_vec_minus(corner[1], corner[0], ab);
    dem_vec_minus(corner[2], corner[0], ac);
    dem_vec_cross(ab, ac, n);
    for (int k = 0; k < 3 && inside; k++)
    {
        double edge[3], to[3], out[3];

        dem_vec_minus(corner[(k + 1)%3], corner[k], edge);
        dem_vec_minus(x, corner[k], to);
        dem_vec_cross(edge, n, out);
        inside = dem_vec_dot(to, out) <= 0.0;
    }
    if (inside)
    {
        dem_vec_minus(x, corner[0], d);
        const double height = dem_vec_dot(d, n)/dem_vec_dot(n, n);

        for (int k = 0; k < 3; k++)
        {
            nearest[k] = x[k] - height*n[k];
        }
        return height*height*dem_vec_dot(n, n);
    }
    for (int k = 0; k < 3; k++)
    {
        double on[3];
        const double square = dem_edge_nearest(corner[k], corner[(k + 1)%3], x, on);

        for (int m = 0; m < 3 && (k == 0 || square < best); m++)
        {
            nearest[m] = on[m];
        }
        best = square < best ? square : best;
    }
    return best;
}
