/*
 * wall_facets.c -- builds the facets of walls: connected coplanar triangles become one facet.
 *
 * 1. Sort the triangles; drop duplicates and triangles without area (wall_triangles.c).
 * 2. Weld corners that coincide within a tolerance.
 * 3. Join triangles that share an edge and are coplanar (union-find, facet_links.h); mark the edges on the rim of
 *    a facet, where all its triangles lie on one side. That may be two triangles: the sides of a
 *    baffle (a plate without thickness) may be cut along different diagonals.
 *    Along periodic axes corners and edges also meet images of others.
 * 4. Number the facets in the order of the sorted triangles; the plane is taken from the largest
 *    triangle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/facet_links.h"
#include "walls/wall_corners.h"
#include "walls/wall_triangles.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "core/vec.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Tolerance of welding corners and of planes being equal, as a fraction of a particle's radius. */
static const double weld_tolerance = 1e-6;

struct edge
{
    size_t a, b, triangle;
    int side;
    int16_t from[3], along[3];    /* periods: of its end a, and from there to its end b */
};

static int compare_edges(const void *p, const void *q)
{
    const struct edge *const e = p, *const f = q;
    const int first = (e->a > f->a) - (e->a < f->a), second = (e->b > f->b) - (e->b < f->b),
              third = memcmp(e->along, f->along, sizeof e->along);

    return first ? first
           : second ? second
           : third  ? third
                    : (e->triangle > f->triangle) - (e->triangle < f->triangle);
}

static int same_edge(const struct edge *e, const struct edge *f)
{
    return e->a == f->a && e->b == f->b && memcmp(e->along, f->along, sizeof e->along) == 0;
}

/* 1 when the first of the numbers that is not 0 is negative. */
static int is_negative(const int16_t n[3])
{
    return n[0] < 0 || (n[0] == 0 && (n[1] < 0 || (n[1] == 0 && n[2] < 0)));
}

/* From the end with the lower label; between images of one corner in the positive direction. */
static void make_edge(const struct dem_vertex *vertex, size_t k, struct edge *e)
{
    const struct dem_vertex *a = &vertex[k], *b = &vertex[k/3*3 + (k + 1)%3];
    int16_t along[3];

    for (int m = 0; m < 3; m++)
    {
        along[m] = (int16_t)(b->period[m] - a->period[m]);
    }
    if (b->label < a->label || (b->label == a->label && is_negative(along)))
    {
        const struct dem_vertex *const other = a;

        a = b;
        b = other;
    }
    *e = (struct edge){.a = a->label, .b = b->label, .triangle = k/3, .side = (int)(k%3)};
    for (int m = 0; m < 3; m++)
    {
        e->from[m] = a->period[m];
        e->along[m] = (int16_t)(b->period[m] - a->period[m]);
    }
}

static void displace(const struct dem_walls *w, const int offset[3], struct dem_triangle *t)
{
    const double *const period = dem_walls_period(w, w->wall[t->wall].frame);

    for (int k = 0; k < 9; k++)
    {
        t->corner[k/3][k%3] += offset[k%3]*period[k%3];
    }
}

/* Measured from the plane of the larger triangle: the plane of a sliver is dominated by
   round-off. */
static int coplanar(const struct dem_triangle *s, const struct dem_triangle *t, double tolerance)
{
    double n[3], m[3], worst = 0.0;
    double size = dem_triangle_area_vector(s, n), other = dem_triangle_area_vector(t, m);
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
           (fabs(dem_vec_dot(n, m)) > 0.999999*size*other ||
            dem_triangle_is_flat(small, 1e3*tolerance));
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

static void join_at(struct dem_walls *w, const struct edge *e, const struct edge *f,
                    struct dem_facet_link *link, double tolerance)
{
    struct dem_triangle *const s = &w->triangle[e->triangle], *const t = &w->triangle[f->triangle];
    struct dem_triangle moved = *t;
    int offset[3];

    for (int k = 0; k < 3; k++)
    {
        offset[k] = e->from[k] - f->from[k];
    }
    displace(w, offset, &moved);
    if (coplanar(s, &moved, tolerance))
    {
        dem_facet_links_unite(link, e->triangle, f->triangle, offset);
        if (!same_side(s, e->side, t, f->side))
        {
            s->rim &= (uint8_t)~(1u << e->side);
            t->rim &= (uint8_t)~(1u << f->side);
        }
    }
}

/* Repeated while a pass finds more axes along which facets are endless: they shorten the offsets of the next one. */
static void join(struct dem_walls *w, const struct edge *edge, size_t edges, struct dem_facet_link *link,
                 double tolerance)
{
    size_t before;

    do
    {
        before = dem_facet_links_endless(link, w->triangles);
        for (size_t k = 0; k < edges; k++)
        {
            for (size_t m = k + 1; m < edges && same_edge(&edge[k], &edge[m]); m++)
            {
                join_at(w, &edge[k], &edge[m], link, tolerance);
            }
        }
    }
    while (dem_facet_links_endless(link, w->triangles) != before);
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

/* Where a triangle belongs in its facet. Along an axis where that is endless all places are one. */
static int set_place(const struct dem_walls *w, const int offset[3], int endless,
                     struct dem_triangle *t)
{
    int place[3];

    for (int k = 0; k < 3; k++)
    {
        place[k] = endless >> k & 1 ? 0 : offset[k];
        DEM_REQUIRE(abs(place[k]) <= 1, DEM_ERROR_INPUT,
                    "wall %s: a plane part of it passes through the periodic faces of domain along %c "
                    "more than once, the limit is once; cut this part into walls of their own",
                    w->wall[t->wall].name, "xyz"[k]);
    }
    t->place = (uint8_t)dem_shift_code(place[0], place[1], place[2]);
    return DEM_OK;
}

static int number_facets(struct dem_walls *w, struct dem_facet_link *link)
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
        int offset[3];
        const size_t first = dem_facet_links_root(link, t, offset);
        double n[3];

        if (first == t)
        {
            const double size = dem_triangle_area_vector(here, n);

            for (int k = 0; k < 3; k++)
            {
                n[k] /= size;
            }
            here->facet = w->facets;
            DEM_TRY(add_facet(w, here->wall, n, here->corner[0]));
            w->facet[here->facet].endless = link[t].endless;
        }
        here->facet = w->triangle[first].facet;
        DEM_TRY(set_place(w, offset, link[first].endless, here));
    }
    return DEM_OK;
}

/* A facet has the plane of its largest triangle, the first of equally large ones. */
static int choose_planes(struct dem_walls *w)
{
    double *largest, n[3];

    DEM_TRY(DEM_NEW(largest, w->facets + 1));
    for (size_t t = 0; t < w->triangles; t++)
    {
        struct dem_facet *const r = &w->facet[w->triangle[t].facet];
        const double size = dem_triangle_area_vector(&w->triangle[t], n);

        if (size > largest[w->triangle[t].facet])
        {
            largest[w->triangle[t].facet] = size;
            dem_walls_set_plane(w, r, &w->triangle[t], size, n);
            r->largest = w->triangle[t].index;
        }
    }
    dem_memory_free(largest);
    return DEM_OK;
}

static int join_triangles(struct dem_walls *w, double scale)
{
    struct edge *edge = NULL;
    struct dem_vertex *vertex = NULL;
    struct dem_facet_link *link = NULL;
    int status = DEM_NEW(edge, 3*w->triangles + 1);

    status = status ? status : DEM_NEW(vertex, 3*w->triangles + 1);
    status = status ? status : DEM_NEW(link, w->triangles + 1);
    status = status ? status : dem_walls_weld_corners(w, weld_tolerance*scale, vertex);
    for (size_t k = 0; k < 3*w->triangles && !status; k++)
    {
        const size_t t = k/3;

        make_edge(vertex, k, &edge[k]);
        w->triangle[t].rim = 7;
        w->triangle[t].index = (uint32_t)t;
        link[t].parent = t;
    }
    if (!status)
    {
        dem_sort_by(edge, 3*w->triangles, sizeof *edge, compare_edges);
        join(w, edge, 3*w->triangles, link, weld_tolerance*scale);
        status = number_facets(w, link);
    }
    dem_memory_free(edge);
    dem_memory_free(vertex);
    dem_memory_free(link);
    return status;
}

int dem_walls_finish(struct dem_walls *w, double scale)
{
    w->all_flat_static = 1;
    w->flatness = weld_tolerance*scale;
    if (w->triangles > 0)
    {
        DEM_TRY(dem_walls_drop_flat(w, weld_tolerance*scale));
        dem_walls_find_boxes(w);
        dem_walls_choose_periods(w);
        DEM_TRY(join_triangles(w, scale));
        DEM_TRY(choose_planes(w));
        DEM_TRY(w->periodic ? dem_walls_compare_images(w) : DEM_OK);
    }
    else
    {
        dem_walls_find_boxes(w);
        DEM_TRY(number_facets(w, NULL));
    }
    dem_walls_measure(w);
    dem_walls_find_push(w);
    return dem_walls_make_marks(w);
}
