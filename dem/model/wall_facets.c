/*
 * wall_facets.c -- builds the facets of walls: connected coplanar triangles become one facet.
 *
 * 1. Sort the triangles; drop duplicates and triangles without area.
 * 2. Weld corners that coincide within a tolerance.
 * 3. Join triangles that share an edge and are coplanar (union-find); mark edges on the rim of a
 *    facet: all triangles at such an edge are on one side of it. Two are there at the edge of a
 *    plate without thickness, a baffle, whose sides are cut along different diagonals.
 * 4. Number the facets in the order of the sorted triangles; the plane is that of the largest
 *    triangle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "model/walls.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "core/vec.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Tolerance of welding corners and of planes being equal, as a fraction of a particle's radius. */
static const double weld_tolerance = 1e-6;

/* ---- sorting and duplicates ------------------------------------------------------------------ */

static int compare_corners(const void *a, const void *b)
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

/* Corners of a triangle in sorted order: independent of the first corner and of the orientation. */
static void sort_corners(const struct dem_triangle *t, double key[3][3])
{
    memcpy(key, t->corner, sizeof t->corner);
    dem_sort_by(key, 3, sizeof key[0], compare_corners);
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
        order = compare_corners(p[k], q[k]);
    }
    return order;
}

static double area_vector(const struct dem_triangle *t, double normal[3])
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

/* 1 when the height of a triangle is at most `height`. It can be dropped: its neighbours have its
   edges too. */
static int is_flat(const struct dem_triangle *t, double height)
{
    double normal[3], edge[3], longest = 0.0;

    for (int k = 0; k < 3; k++)
    {
        dem_vec_minus(t->corner[(k + 1)%3], t->corner[k], edge);
        longest = fmax(longest, dem_vec_norm(edge));
    }
    return area_vector(t, normal) <= height*longest;
}

static int drop_degenerate(struct dem_walls *w, double scale)
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
        else if (is_flat(&w->triangle[t], weld_tolerance*scale))
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
            w->wall[k].name, w->wall[k].flat, weld_tolerance*scale);
    }
    return DEM_OK;
}

/* ---- welding --------------------------------------------------------------------------------- */

struct corner
{
    double x[3];
    size_t at;                    /* 3 triangle + corner */
};

static int compare_corner_positions(const void *a, const void *b)
{
    return compare_corners(((const struct corner *)a)->x, ((const struct corner *)b)->x);
}

/* Label the corners so that coincident ones share a label: sort by x, compare within the
   tolerance. */
static int weld_corners(const struct dem_walls *w, double tolerance, size_t *label)
{
    struct corner *c;

    DEM_TRY(DEM_NEW(c, 3*w->triangles + 1));
    for (size_t k = 0; k < 3*w->triangles; k++)
    {
        memcpy(c[k].x, w->triangle[k/3].corner[k%3], sizeof c[k].x);
        c[k].at = k;
    }
    dem_sort_by(c, 3*w->triangles, sizeof *c, compare_corner_positions);
    for (size_t k = 0; k < 3*w->triangles; k++)
    {
        label[c[k].at] = c[k].at;
        for (size_t m = k; m-- > 0 && c[k].x[0] - c[m].x[0] <= tolerance;)
        {
            double d[3];

            dem_vec_minus(c[k].x, c[m].x, d);
            if (dem_vec_norm(d) <= tolerance)
            {
                label[c[k].at] = label[c[m].at];
                break;
            }
        }
    }
    dem_memory_free(c);
    return DEM_OK;
}

/* ---- facets ---------------------------------------------------------------------------------- */

struct edge
{
    size_t a, b, triangle;
    int side;
};

static int compare_edges(const void *p, const void *q)
{
    const struct edge *const e = p, *const f = q;
    const int first = (e->a > f->a) - (e->a < f->a), second = (e->b > f->b) - (e->b < f->b);

    return first ? first
           : second ? second
                    : (e->triangle > f->triangle) - (e->triangle < f->triangle);
}

static size_t root(size_t *parent, size_t t)
{
    while (parent[t] != t)
    {
        t = parent[t] = parent[parent[t]];
    }
    return t;
}

/* Measured from the plane of the larger triangle: the plane of a sliver is dominated by
   round-off. */
static int coplanar(const struct dem_triangle *s, const struct dem_triangle *t, double tolerance)
{
    double n[3], m[3], worst = 0.0;
    double size = area_vector(s, n), other = area_vector(t, m);
    const int swap = other > size;
    const struct dem_triangle *const large = swap ? t : s, *const small = swap ? s : t;
    const double *const normal = swap ? m : n;

    for (int k = 0; k < 3; k++)
    {
        double d[3];

        dem_vec_minus(small->corner[k], large->corner[0], d);
        worst = fmax(worst, fabs(dem_vec_dot(d, normal))/(swap ? other : size));
    }
    return s->wall == t->wall && worst <= tolerance &&
           (fabs(dem_vec_dot(n, m)) > 0.999999*size*other || is_flat(small, 1e3*tolerance));
}

/* From an edge to the third corner, across the edge. */
static void across(const struct dem_triangle *t, int side, double out[3])
{
    const double *const from = t->corner[side];
    double along[3], away[3];

    dem_vec_minus(t->corner[(side + 1)%3], from, along);
    dem_vec_minus(t->corner[(side + 2)%3], from, away);
    const double over = dem_vec_dot(away, along)/dem_vec_dot(along, along);

    for (int k = 0; k < 3; k++)
    {
        out[k] = away[k] - over*along[k];
    }
}

/* 1 when coplanar triangles are on the same side of the edge that they share. Half of the cosine
   leaves room for slivers, whose directions are uncertain. */
static int same_side(const struct dem_triangle *s, int side, const struct dem_triangle *t,
                     int other_side)
{
    double a[3], b[3];

    across(s, side, a);
    across(t, other_side, b);
    return dem_vec_dot(a, b) > 0.5*dem_vec_norm(a)*dem_vec_norm(b);
}

static void join(struct dem_walls *w, struct edge *edge, size_t edges, size_t *parent,
                 double tolerance)
{
    for (size_t k = 0; k < edges; k++)
    {
        for (size_t m = k + 1; m < edges && edge[m].a == edge[k].a && edge[m].b == edge[k].b; m++)
        {
            const size_t s = edge[k].triangle, t = edge[m].triangle;

            if (coplanar(&w->triangle[s], &w->triangle[t], tolerance))
            {
                const size_t rs = root(parent, s), rt = root(parent, t);

                parent[rs > rt ? rs : rt] = rs > rt ? rt : rs;
                if (!same_side(&w->triangle[s], edge[k].side, &w->triangle[t], edge[m].side))
                {
                    w->triangle[s].rim &= (uint16_t)~(1u << edge[k].side);
                    w->triangle[t].rim &= (uint16_t)~(1u << edge[m].side);
                }
            }
        }
    }
}

static int add_facet(struct dem_walls *w, int wall, const double normal[3], const double point[3])
{
    struct dem_wall *const of = &w->wall[wall];
    struct dem_facet *r;

    DEM_TRY(DEM_GROW(w->facet, w->facet_capacity, w->facets + 1));
    of->first_facet = of->facets > 0 ? of->first_facet : w->facets;
    of->facets++;
    r = &w->facet[w->facets];
    *r = (struct dem_facet){.wall = wall,
                            .number = w->facets++,
                            .shape = of->shape,
                            .outside = of->outside,
                            .radius = of->radius,
                            .offset = dem_vec_dot(normal, point)};
    memcpy(r->normal, normal, sizeof r->normal);
    memcpy(r->centre, point, sizeof r->centre);
    w->all_flat_static &= (of->shape == DEM_SHAPE_PLANE || of->shape == DEM_SHAPE_TRIANGLES) &&
                          of->frame < 0 && !of->driven;
    return DEM_OK;
}

static int number_facets(struct dem_walls *w, size_t *parent)
{
    for (int k = 0; k < w->walls; k++)
    {
        if (w->wall[k].shape != DEM_SHAPE_TRIANGLES)
        {
            DEM_TRY(add_facet(w, k, w->wall[k].normal, w->wall[k].point));
        }
    }
    for (size_t t = 0; t < w->triangles; t++)
    {
        struct dem_triangle *const here = &w->triangle[t];
        const size_t first = root(parent, t);
        double n[3];

        if (first == t)
        {
            const double size = area_vector(here, n);

            for (int k = 0; k < 3; k++)
            {
                n[k] /= size;
            }
            here->facet = w->facets;
            DEM_TRY(add_facet(w, here->wall, n, here->corner[0]));
        }
        here->facet = w->triangle[first].facet;
    }
    return DEM_OK;
}

/* The plane of a facet is that of its largest triangle, the first of equally large ones. */
static int choose_planes(struct dem_walls *w)
{
    double *largest, n[3];

    DEM_TRY(DEM_NEW(largest, w->facets + 1));
    for (size_t t = 0; t < w->triangles; t++)
    {
        struct dem_facet *const r = &w->facet[w->triangle[t].facet];
        const double size = area_vector(&w->triangle[t], n);

        if (size > largest[w->triangle[t].facet])
        {
            largest[w->triangle[t].facet] = size;
            for (int k = 0; k < 3; k++)
            {
                r->normal[k] = n[k]/size;
            }
            r->offset = dem_vec_dot(r->normal, w->triangle[t].corner[0]);
            r->largest = w->triangle[t].index;
        }
    }
    dem_memory_free(largest);
    return DEM_OK;
}

static int join_triangles(struct dem_walls *w, double scale)
{
    struct edge *edge = NULL;
    size_t *label = NULL, *parent = NULL;
    int status = DEM_NEW(edge, 3*w->triangles + 1);

    status = status ? status : DEM_NEW(label, 3*w->triangles + 1);
    status = status ? status : DEM_NEW(parent, w->triangles + 1);
    status = status ? status : weld_corners(w, weld_tolerance*scale, label);
    for (size_t k = 0; k < 3*w->triangles && !status; k++)
    {
        const size_t t = k/3, a = label[k], b = label[3*t + (k + 1)%3];

        edge[k] = (struct edge){.a = a < b ? a : b,
                                .b = a < b ? b : a,
                                .triangle = t,
                                .side = (int)(k%3)};
        w->triangle[t].rim = 7;
        w->triangle[t].index = (uint32_t)t;
        parent[t] = t;
    }
    if (!status)
    {
        dem_sort_by(edge, 3*w->triangles, sizeof *edge, compare_edges);
        join(w, edge, 3*w->triangles, parent, weld_tolerance*scale);
        status = number_facets(w, parent);
    }
    dem_memory_free(edge);
    dem_memory_free(label);
    dem_memory_free(parent);
    return status;
}

/* Area and centroid of the triangles of each wall. */
static void measure(struct dem_walls *w)
{
    for (size_t t = 0; t < w->triangles; t++)
    {
        const struct dem_triangle *const here = &w->triangle[t];
        struct dem_wall *const of = &w->wall[here->wall];
        double n[3];
        const double area = 0.5*area_vector(here, n);

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

/* Which frames have walls of triangles, and their boxes. */
static void find_boxes(struct dem_walls *w)
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
        struct dem_wall_frame *const f = &w->frame[w->wall[here->wall].frame];

        for (int k = 0; k < 9 && w->wall[here->wall].frame >= 0; k++)
        {
            f->box[0][k%3] = fmin(f->box[0][k%3], here->corner[k/3][k%3]);
            f->box[1][k%3] = fmax(f->box[1][k%3], here->corner[k/3][k%3]);
        }
    }
}

int dem_walls_finish(struct dem_walls *w, double scale)
{
    w->all_flat_static = 1;
    w->flatness = weld_tolerance*scale;
    if (w->triangles > 0)
    {
        DEM_TRY(drop_degenerate(w, scale));
        DEM_TRY(join_triangles(w, scale));
        DEM_TRY(choose_planes(w));
    }
    else
    {
        DEM_TRY(number_facets(w, NULL));
    }
    measure(w);
    find_boxes(w);
    return dem_walls_make_marks(w);
}
