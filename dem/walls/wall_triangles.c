/*
 * wall_triangles.c -- sort the triangles of walls, drop duplicates and those without area, measure
 * the rest.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/wall_triangles.h"
#include "walls/wall_corners.h"
#include "core/error.h"
#include "core/sort.h"
#include "core/vec.h"
#include <math.h>
#include <string.h>

/* Corners of a triangle in sorted order: independent of the first corner and of the orientation. */
static void sort_corners(const struct dem_triangle *t, double key[3][3])
{
    memcpy(key, t->corner, sizeof t->corner);
    for (int k = 0; k < 3; k++)    /* compares 0 with 1, 1 with 2, 0 with 1 */
    {
        double *const p = key[k%2], *const q = key[k%2 + 1], held[3];

        if (dem_walls_compare_corners(p, q) > 0)
        {
            memcpy(held, p, sizeof held);
            memcpy(p, q, sizeof held);
            memcpy(q, held, sizeof held);
        }
    }
}

static int compare_triangles(const void *a, const void *b)
{
    const struct dem_triangle *const s = a, *const t = b;
    double p[3][3], q[3][3];
    int order = (s->wall > t->wall) - (s->wall < t->wall);

    sort_corners(s, p);
    sort_corners(t, q);
    for (int k = 0; k < 3 && order == 0; k++)
    {
        order = dem_walls_compare_corners(p[k], q[k]);
    }
    return order;
}

double dem_triangle_area_vector(const struct dem_triangle *t, double normal[3])
{
    double a[3], b[3];

    dem_vec_minus(t->corner[1], t->corner[0], a);
    dem_vec_minus(t->corner[2], t->corner[0], b);
    dem_vec_cross(a, b, normal);
    return dem_vec_norm(normal);
}

static int same_corners(const struct dem_triangle *s, const struct dem_triangle *t)
{
    double p[3][3], q[3][3];

    sort_corners(s, p);
    sort_corners(t, q);
    return memcmp(p, q, sizeof p) == 0;
}

int dem_triangle_is_flat(const struct dem_triangle *t, double height)
{
    double normal[3], edge[3], longest = 0.0;

    for (int k = 0; k < 3; k++)
    {
        dem_vec_minus(t->corner[(k + 1)%3], t->corner[k], edge);
        longest = fmax(longest, dem_vec_norm(edge));
    }
    return dem_triangle_area_vector(t, normal) <= height*longest;
}

int dem_walls_drop_flat(struct dem_walls *w, double height)
{
    size_t kept = 0;

    dem_sort_by(w->triangle, w->triangles, sizeof *w->triangle, compare_triangles);
    for (size_t t = 0; t < w->triangles; t++)
    {
        struct dem_wall *const wall = &w->wall[w->triangle[t].wall];

        if (kept > 0 && w->triangle[kept - 1].wall == w->triangle[t].wall &&
            same_corners(&w->triangle[kept - 1], &w->triangle[t]))
        {
            wall->repeats++;
        }
        else if (dem_triangle_is_flat(&w->triangle[t], height))
        {
            wall->flat++;
        }
        else
        {
            w->triangle[kept++] = w->triangle[t];
            wall->triangles++;
        }
    }
    w->triangles = kept;
    for (int k = 0; k < w->walls; k++)
    {
        DEM_REQUIRE(
            w->wall[k].triangles > 0 || w->wall[k].flat == 0, DEM_ERROR_INPUT,
            "wall %s: none of its %zu triangles is higher than %.3g m (1e-6 of the largest radius); give a surface "
            "with an area, in metres",
            w->wall[k].name, w->wall[k].flat, height);
    }
    return DEM_OK;
}

void dem_walls_measure(struct dem_walls *w)
{
    for (size_t t = 0; t < w->triangles; t++)
    {
        const struct dem_triangle *const here = &w->triangle[t];
        struct dem_wall *const of = &w->wall[here->wall];
        double n[3];
        const double area = 0.5*dem_triangle_area_vector(here, n);

        of->area += area;
        for (int k = 0; k < 3; k++)
        {
            of->centroid[k] +=
                area*(here->corner[0][k] + here->corner[1][k] + here->corner[2][k])/3.0;
        }
    }
    for (int k = 0; k < w->walls; k++)
    {
        for (int a = 0; a < 3 && w->wall[k].area > 0.0; a++)
        {
            w->wall[k].centroid[a] /= w->wall[k].area;
        }
    }
}

void dem_walls_find_boxes(struct dem_walls *w)
{
    for (int k = 0; k < w->walls; k++)
    {
        if (w->wall[k].frame >= 0)
        {
            w->frame[w->wall[k].frame].triangles |= w->wall[k].shape == DEM_SHAPE_TRIANGLES;
        }
    }
    for (int k = 0; k < w->frames; k++)
    {
        for (int a = 0; a < 3; a++)
        {
            w->frame[k].box[0][a] = INFINITY;
            w->frame[k].box[1][a] = -INFINITY;
        }
    }
    for (size_t t = 0; t < w->triangles; t++)
    {
        const struct dem_triangle *const here = &w->triangle[t];
        const int frame = w->wall[here->wall].frame;

        for (int k = 0; k < 9 && frame >= 0; k++)
        {
            double(*const box)[3] = w->frame[frame].box;

            box[0][k%3] = fmin(box[0][k%3], here->corner[k/3][k%3]);
            box[1][k%3] = fmax(box[1][k%3], here->corner[k/3][k%3]);
        }
    }
}
