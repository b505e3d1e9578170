/*
 * wall_grid.c -- grid of the triangles of walls; triangles and their periodic images near a point.
 *
 * The grid has the triangles where they were given. To find their images, the search is repeated at
 * the point less n periods, for every n that brings it within reach of the grid.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/wall_search.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include <math.h>
#include <string.h>

/* A triangle is skipped when the plane of its facet is out of reach. The factor is far above
   round-off and the tolerance of flatness. */
static const double reach_margin = 1.001;

enum
{
    MAX_CELLS = 1 << 21
};

/* ---- the grid -------------------------------------------------------------------------------- */

static void triangle_box(const struct dem_triangle *t, double box[2][3])
{
    for (int k = 0; k < 3; k++)
    {
        box[0][k] = fmin(t->corner[0][k], fmin(t->corner[1][k], t->corner[2][k]));
        box[1][k] = fmax(t->corner[0][k], fmax(t->corner[1][k], t->corner[2][k]));
    }
}

static void cell_range(const struct dem_wall_search *s, double box[2][3], double margin,
                       int from[3], int to[3])
{
    for (int k = 0; k < 3; k++)
    {
        const double a = floor((box[0][k] - margin - s->origin[k])/s->edge);
        const double b = floor((box[1][k] + margin - s->origin[k])/s->edge);

        /* no cell for what is not a number */
        from[k] = !(a >= 0.0) ? 0 : a > s->cells[k] ? s->cells[k] : (int)a;
        to[k] = !(b >= -1.0) ? -1 : b > s->cells[k] - 1 ? s->cells[k] - 1 : (int)b;
    }
}

/* For each cell that the box of a triangle meets: count it (entry NULL), or store the triangle in
   it. */
static void count_or_store(struct dem_wall_search *s, const struct dem_walls *w, size_t *next,
                           uint32_t *entry)
{
    for (size_t t = 0; t < w->triangles; t++)
    {
        double box[2][3];
        int from[3], to[3];

        triangle_box(&w->triangle[t], box);
        cell_range(s, box, 1e-9*s->edge, from, to);
        for (int z = from[2]; z <= to[2]; z++)
        {
            for (int y = from[1]; y <= to[1]; y++)
            {
                for (int x = from[0]; x <= to[0]; x++)
                {
                    const size_t cell =
                        ((size_t)z*(size_t)s->cells[1] + (size_t)y)*(size_t)s->cells[0] +
                        (size_t)x;

                    if (entry)
                    {
                        entry[next[cell]] = (uint32_t)t;
                    }
                    next[cell]++;
                }
            }
        }
    }
}

static void size_grid(struct dem_wall_search *s, const struct dem_walls *w, double radius)
{
    double all[2][3] = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}},
           cells = 1.0;

    for (size_t t = 0; t < w->triangles; t++)
    {
        double box[2][3];

        triangle_box(&w->triangle[t], box);
        for (int k = 0; k < 3; k++)
        {
            all[0][k] = fmin(all[0][k], box[0][k]);
            all[1][k] = fmax(all[1][k], box[1][k]);
        }
    }
    s->edge = 3.0*radius;
    do
    {
        cells = 1.0;
        for (int k = 0; k < 3; k++)
        {
            s->origin[k] = all[0][k];
            cells *= s->cells[k] = (int)fmin(2.0*MAX_CELLS, (all[1][k] - all[0][k])/s->edge) + 1;
        }
        s->edge *= cells > MAX_CELLS ? 1.26 : 1.0;
    } while (cells > MAX_CELLS);
}

/* next: one number a cell, zero. */
static int fill_grid(struct dem_wall_search *s, const struct dem_walls *w, size_t cells,
                     size_t *next)
{
    count_or_store(s, w, next, NULL);
    for (size_t c = 0; c < cells; c++)
    {
        s->start[c + 1] = s->start[c] + next[c];
        next[c] = s->start[c];
    }
    DEM_TRY(DEM_NEW(s->entry, s->start[cells] + 1));
    count_or_store(s, w, next, s->entry);
    return DEM_OK;
}

int dem_wall_search_prepare(struct dem_wall_search *s, const struct dem_walls *w, double radius)
{
    size_t *next = NULL;

    dem_memory_free(s->start);
    dem_memory_free(s->entry);
    dem_memory_free(s->seen);
    s->start = NULL;                                      /* an allocation that fails leaves them so */
    s->entry = s->seen = NULL;
    s->stamp = 0;
    s->radius = radius;
    s->path_length = w->path_length;
    if (w->triangles == 0)
    {
        return DEM_OK;
    }
    size_grid(s, w, radius);
    const size_t cells = (size_t)s->cells[0]*(size_t)s->cells[1]*(size_t)s->cells[2];

    DEM_TRY(DEM_NEW(s->start, cells + 1));
    DEM_TRY(DEM_NEW(s->seen, w->triangles));
    DEM_TRY(DEM_NEW(next, cells + 1));
    const int status = fill_grid(s, w, cells, next);

    dem_memory_free(next);
    return status;
}

/* ---- triangles near a point ------------------------------------------------------------------ */

static inline double plane_height(const struct dem_walls *w, uint32_t t, const double x[3])
{
    const struct dem_facet *const r = &w->facet[w->triangle[t].facet];

    return dem_vec_dot(r->normal, x) - r->offset;
}

/* Without images. */
static int gather_at(struct dem_wall_search *s, const struct dem_walls *w, int frame,
                     const double x[3], double reach)
{
    double box[2][3], nearest[3];
    int from[3], to[3];

    memcpy(box[0], x, sizeof box[0]);
    memcpy(box[1], x, sizeof box[1]);
    cell_range(s, box, reach, from, to);
    s->stamp++;
    for (int z = from[2]; z <= to[2]; z++)
    {
        for (int y = from[1]; y <= to[1]; y++)
        {
            const size_t row = ((size_t)z*(size_t)s->cells[1] + (size_t)y)*(size_t)s->cells[0];

            for (size_t e = s->start[row + (size_t)from[0]];
                 from[0] <= to[0] && e < s->start[row + (size_t)to[0] + 1]; e++)
            {
                const uint32_t t = s->entry[e];

                if (s->seen[t] != s->stamp && w->wall[w->triangle[t].wall].frame == frame &&
                    fabs(plane_height(w, t, x)) < reach_margin*reach &&
                    dem_triangle_nearest(&w->triangle[t], x, nearest) < reach*reach)
                {
                    DEM_TRY(DEM_GROW(s->candidate, s->candidate_capacity, s->candidates + 1));
                    s->candidate[s->candidates++] = t;
                }
                s->seen[t] = s->stamp;
            }
        }
    }
    return DEM_OK;
}

static int gather_image(struct dem_wall_search *s, const struct dem_walls *w, int frame,
                        const double x[3], double reach, struct dem_wall_image image)
{
    size_t first = s->candidates;
    double moved[3];

    DEM_TRY(gather_at(s, w, frame,
                      dem_walls_from_image(dem_walls_period(w, frame), image.n, x, moved), reach));
    DEM_TRY(DEM_GROW(s->image, s->image_capacity, s->candidates + 1));
    for (; first < s->candidates; first++)
    {
        s->image[first] = image;
    }
    return DEM_OK;
}

int dem_wall_search_gather(struct dem_wall_search *s, const struct dem_walls *w, int frame,
                           const double x[3], double reach)
{
    int range[3][2];

    if (!w->periodic)
    {
        return gather_at(s, w, frame, x, reach);
    }
    for (int k = 0; k < 3; k++)
    {
        const double grid[2] = {s->origin[k], s->origin[k] + s->cells[k]*s->edge},
                     around[2] = {x[k] - reach, x[k] + reach};

        dem_walls_image_range(dem_walls_period(w, frame)[k], grid, around, range[k]);
    }
    for (int a = range[0][0]; a <= range[0][1]; a++)
    {
        for (int b = range[1][0]; b <= range[1][1]; b++)
        {
            for (int c = range[2][0]; c <= range[2][1]; c++)
            {
                DEM_TRY(gather_image(s, w, frame, x, reach,
                                     (struct dem_wall_image){{(int8_t)a, (int8_t)b, (int8_t)c}}));
            }
        }
    }
    return DEM_OK;
}
