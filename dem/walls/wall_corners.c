/*
 * wall_corners.c -- label the corners of triangles so that coincident ones share a label.
 *
 * Along periodic axes corners are first brought into one period.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/wall_corners.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "core/vec.h"
#include <math.h>
#include <string.h>

int dem_walls_compare_corners(const void *a, const void *b)
{
    const double *const p = a, *const q = b;

    for (int k = 0; k < 3; k++)
    {
        if (p[k] < q[k] || p[k] > q[k])
        {
            return p[k] < q[k] ? -1 : 1;
        }
    }
    return 0;
}

/* Single precision of coordinates, as of a binary STL file: by this fraction of them the ends of a
   surface may miss each other at a periodic face, but by no more than a multiple of the tolerance. */
static const double single_precision = 1.2e-7, most = 1e3;

struct corner
{
    double x[3];                  /* m, inside a period */
    int16_t period[3];            /* in which it is */
    size_t at;                    /* 3 triangle + corner */
};

/* Corners are sorted along a direction that no grid has, so that few of a mesh are at one place along it. */
static const double along[3] = {0.5257311121, 0.6180339887, 0.5844873543};

static int compare_corner_positions(const void *a, const void *b)
{
    const double *const p = ((const struct corner *)a)->x, *const q = ((const struct corner *)b)->x;
    const double s = dem_vec_dot(p, along), t = dem_vec_dot(q, along);

    return s < t ? -1 : s > t ? 1 : dem_walls_compare_corners(p, q);
}

static int compare_numbers(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;

    return (p > q) - (p < q);
}

static double period_of(const struct dem_walls *w, const struct corner *c, int axis)
{
    return dem_walls_period(w, w->wall[w->triangle[c->at/3].wall].frame)[axis];
}

/* Bring the corners into one period along an axis. It begins in the middle of the largest gap between
   corners, where none is near. `sorted`: scratch. */
static void wrap_corners(const struct dem_walls *w, struct corner *c, size_t n, int axis,
                         double *sorted)
{
    const double period = w->period[axis];
    double begin = 0.0, largest = -1.0;
    size_t m = 0;

    for (size_t k = 0; k < n; k++)
    {
        if (period_of(w, &c[k], axis) > 0.0)
        {
            sorted[m++] = c[k].x[axis] - period*floor(c[k].x[axis]/period);
        }
    }
    dem_sort_by(sorted, m, sizeof *sorted, compare_numbers);
    for (size_t k = 0; k < m; k++)
    {
        const double gap = (k > 0 ? sorted[k - 1] : sorted[m - 1] - period) - sorted[k];

        begin = -gap > largest ? sorted[k] + 0.5*gap : begin;
        largest = fmax(largest, -gap);
    }
    for (size_t k = 0; k < n; k++)
    {
        if (period_of(w, &c[k], axis) > 0.0)
        {
            const double there = floor((c[k].x[axis] - begin)/period);

            c[k].period[axis] =
                (int16_t)fmax(-DEM_WALL_IMAGES, fmin(DEM_WALL_IMAGES, there));
            c[k].x[axis] -= c[k].period[axis]*period;
        }
    }
}

/* 1 when two corners coincide: to `tolerance`, or at different periods to the tolerance of a surface stored in
   single precision. */
static int coincide(const struct corner *a, const struct corner *b, double tolerance,
                    double across_faces)
{
    double d[3];

    dem_vec_minus(a->x, b->x, d);
    return dem_vec_norm(d) <= (memcmp(a->period, b->period, sizeof a->period) == 0
                                   ? tolerance : across_faces);
}

/* Label the corners so that coincident ones share a label: sort, compare within the tolerance. Twice that along
   the direction leaves room for round-off. */
static void label_corners(struct corner *c, size_t n, double tolerance, double across_faces,
                          struct dem_vertex *vertex)
{
    dem_sort_by(c, n, sizeof *c, compare_corner_positions);
    for (size_t k = 0; k < n; k++)
    {
        struct dem_vertex *const here = &vertex[c[k].at];

        here->label = c[k].at;
        memcpy(here->period, c[k].period, sizeof here->period);
        const double end = dem_vec_dot(c[k].x, along) - 2.0*across_faces;

        for (size_t m = k; m-- > 0 && dem_vec_dot(c[m].x, along) >= end;)
        {
            if (coincide(&c[k], &c[m], tolerance, across_faces))
            {
                here->label = vertex[c[m].at].label;
                break;
            }
        }
    }
}

int dem_walls_weld_corners(const struct dem_walls *w, double tolerance,
                           struct dem_vertex *vertex)
{
    const size_t n = 3*w->triangles;
    double across_faces = tolerance, *sorted = NULL;
    struct corner *c;

    DEM_TRY(DEM_NEW(c, n + 1));
    const int status = w->periodic ? DEM_NEW(sorted, n + 1) : DEM_OK;

    for (size_t k = 0; k < n && !status; k++)
    {
        c[k] = (struct corner){.at = k};
        memcpy(c[k].x, w->triangle[k/3].corner[k%3], sizeof c[k].x);
        for (int a = 0; a < 3 && w->periodic; a++)
        {
            across_faces = fmax(across_faces, fmin(single_precision*fabs(c[k].x[a]),
                                                   most*tolerance));
        }
    }
    for (int axis = 0; axis < 3 && w->periodic && !status; axis++)
    {
        wrap_corners(w, c, n, axis, sorted);
    }
    if (!status)
    {
        label_corners(c, n, tolerance, across_faces, vertex);
    }
    dem_memory_free(sorted);
    dem_memory_free(c);
    return status;
}
