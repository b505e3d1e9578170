/*
 * triangle_nearest.c -- the point of a triangle, or of an edge, nearest to a position.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/wall_search.h"
#include "core/vec.h"
#include <math.h>
#include <string.h>

double dem_edge_nearest(const double a[3], const double b[3], const double x[3], double nearest[3])
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

double dem_triangle_nearest(const struct dem_triangle *t, const double x[3], double nearest[3])
{
    double ab[3], ac[3], n[3], d[3], best = INFINITY;
    int inside = 1;

    dem_vec_minus(t->corner[1], t->corner[0], ab);
    dem_vec_minus(t->corner[2], t->corner[0], ac);
    dem_vec_cross(ab, ac, n);
    for (int k = 0; k < 3 && inside; k++)
    {
        const double *const a = t->corner[k];
        double edge[3], to[3], out[3];

        dem_vec_minus(t->corner[(k + 1)%3], a, edge);
        dem_vec_minus(x, a, to);
        dem_vec_cross(edge, n, out);
        inside = dem_vec_dot(to, out) <= 0.0;
    }
    if (inside)
    {
        dem_vec_minus(x, t->corner[0], d);
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
        const double square = dem_edge_nearest(t->corner[k], t->corner[(k + 1)%3], x, on);

        if (square < best)
        {
            best = square;
            memcpy(nearest, on, sizeof on);
        }
    }
    return best;
}
