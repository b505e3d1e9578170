/*
 * wall_search.c -- for each particle the facets within reach.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/wall_search.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include <float.h>
#include <math.h>
#include <string.h>

void dem_wall_search_free(struct dem_wall_search *s)
{
    dem_memory_free(s->start);
    dem_memory_free(s->entry);
    dem_memory_free(s->neighbor);
    dem_memory_free(s->candidate);
    dem_memory_free(s->image);
    dem_memory_free(s->seen);
    memset(s, 0, sizeof *s);
}

/* ---- nearest point --------------------------------------------------------------------------- */

double dem_wall_search_nearest(const struct dem_wall_search *s, const struct dem_walls *w,
                               const struct dem_wall_neighbor *near, const double x[3],
                               double point[3], double away[3])
{
    double best = DBL_MAX, here[3], moved[3];

    for (uint32_t c = near->first; c < near->first + near->count; c++)
    {
        const double *const from = dem_wall_from_candidate(s, w, c, x, moved);
        const double square = dem_triangle_nearest(&w->triangle[s->candidate[c]], from, here);

        if (square < best)
        {
            best = square;
            dem_vec_minus(from, here, away);
            for (int k = 0; k < 3; k++)
            {
                point[k] = from == x ? here[k] : here[k] + (x[k] - from[k]);
            }
        }
    }
    return sqrt(best);
}

double dem_wall_search_distance(const struct dem_wall_search *s, const struct dem_walls *w,
                                const struct dem_wall_neighbor *near, const double global[3])
{
    const struct dem_facet *const r = &w->facet[near->facet];
    double local_x[3], there[3], away[3];
    const double *const x = dem_walls_to_frame(w, r->wall, global, local_x);

    if (!dem_wall_neighbor_open(w, near))
    {
        return dem_wall_search_nearest(s, w, near, x, there, away);
    }
    const double h = dem_facet_height(r, dem_wall_from_facet(w, near, x, away), there);

    return r->shape == DEM_SHAPE_TRIANGLES ? fabs(h) : h;
}

/* ---- other triangles held -------------------------------------------------------------------- */

void dem_wall_search_use_indices(struct dem_wall_search *s, const struct dem_walls *w)
{
    for (size_t c = 0; c < s->candidates; c++)
    {
        s->candidate[c] = w->triangle[s->candidate[c]].index;
    }
    for (size_t k = 0; k < s->neighbors; k++)
    {
        s->neighbor[k].facet = w->facet[s->neighbor[k].facet].number;
    }
}

static int facet_held(const struct dem_walls *w, int number)
{
    int from = 0, to = w->facets;

    while (from < to)
    {
        const int middle = from + (to - from)/2;

        from = w->facet[middle].number < number ? middle + 1 : from;
        to = w->facet[middle].number < number ? to : middle;
    }
    return from;
}

void dem_wall_search_use_held(struct dem_wall_search *s, const struct dem_walls *w)
{
    for (size_t c = 0; c < s->candidates; c++)
    {
        s->candidate[c] = (uint32_t)dem_walls_find(w, s->candidate[c]);
    }
    for (size_t k = 0; k < s->neighbors; k++)
    {
        s->neighbor[k].facet = facet_held(w, s->neighbor[k].facet);
    }
}

/* ---- search ---------------------------------------------------------------------------------- */

static int add_neighbor(struct dem_wall_search *s, uint32_t particle, int facet, int open,
                        struct dem_wall_neighbor **near)
{
    DEM_TRY(DEM_GROW(s->neighbor, s->neighbor_capacity, s->neighbors + 1));
    *near = &s->neighbor[s->neighbors++];
    **near = (struct dem_wall_neighbor){.particle = particle,
                                        .facet = facet,
                                        .open = (uint8_t)open,
                                        .first = (uint32_t)s->candidates};
    return DEM_OK;
}

/* Facets without triangles: these have the lowest numbers. */
static int find_primitives(struct dem_wall_search *s, const struct dem_walls *w,
                           const struct dem_particle *p, uint32_t particle, double skin)
{
    struct dem_wall_neighbor *near;
    double local_x[3], normal[3];

    for (int r = 0; r < w->facets && w->facet[r].shape != DEM_SHAPE_TRIANGLES; r++)
    {
        const double *const x = dem_walls_to_frame(w, w->facet[r].wall, p->x, local_x);

        if (!w->wall[w->facet[r].wall].absent
            && dem_facet_height(&w->facet[r], x, normal) < p->radius + skin)
        {
            DEM_TRY(add_neighbor(s, particle, r, 1, &near));
        }
    }
    return DEM_OK;
}

/* a triangle or an image of one, and the facet */
struct found
{
    uint32_t triangle;
    int facet;
    struct dem_wall_image image, of_facet;
};

static struct found found_at(const struct dem_wall_search *s, const struct dem_walls *w, size_t c)
{
    const struct dem_triangle *const t = &w->triangle[s->candidate[c]];
    struct found f = {.triangle = s->candidate[c], .facet = t->facet};

    if (s->image)
    {
        f.image = s->image[c];
        for (int k = 0; k < 3; k++)
        {
            f.of_facet.n[k] = (int8_t)(w->facet[t->facet].endless >> k & 1
                                           ? 0 : f.image.n[k] - dem_shift_axis(t->place, k));
        }
    }
    return f;
}

static int compare_images(const struct dem_wall_image *a, const struct dem_wall_image *b)
{
    int order = 0;

    for (int k = 0; k < 3 && order == 0; k++)
    {
        order = (a->n[k] > b->n[k]) - (a->n[k] < b->n[k]);
    }
    return order;
}

/* By facet, image of the facet, triangle, image of the triangle. */
static int comes_after(const struct found *a, const struct found *b)
{
    const int facets = (a->facet > b->facet) - (a->facet < b->facet),
              images = compare_images(&a->of_facet, &b->of_facet),
              triangles = (a->triangle > b->triangle) - (a->triangle < b->triangle);

    return (facets      ? facets
            : images    ? images
            : triangles ? triangles
                        : compare_images(&a->image, &b->image)) > 0;
}

static void sort_by_facet(struct dem_wall_search *s, const struct dem_walls *w, size_t first)
{
    for (size_t k = first + 1; k < s->candidates; k++)
    {
        const struct found here = found_at(s, w, k);
        size_t m = k;

        for (; m > first; m--)
        {
            const struct found before = found_at(s, w, m - 1);

            if (!comes_after(&before, &here))
            {
                break;
            }
            s->candidate[m] = before.triangle;
            if (s->image)
            {
                s->image[m] = before.image;
            }
        }
        s->candidate[m] = here.triangle;
        if (s->image)
        {
            s->image[m] = here.image;
        }
    }
}

static int rim_in_reach(const struct dem_triangle *t, const double x[3], double reach)
{
    double on[3];

    for (int k = 0; k < 3; k++)
    {
        if ((t->rim >> k & 1u) &&
            dem_edge_nearest(t->corner[k], t->corner[(k + 1)%3], x, on) < reach*reach)
        {
            return 1;
        }
    }
    return 0;
}

static int find_triangulated(struct dem_wall_search *s, const struct dem_walls *w,
                             const struct dem_particle *p, uint32_t particle, double skin)
{
    const size_t first = s->candidates;
    const double reach = p->radius + skin;
    struct dem_wall_neighbor *near = NULL;
    double local_x[3], moved[3];

    DEM_TRY(dem_wall_search_gather(s, w, -1, p->x, reach));
    for (int k = 0; k < w->frames; k++)
    {
        if (w->frame[k].triangles)
        {
            dem_pose_to_frame(&w->frame[k].pose, p->x, local_x);
            DEM_TRY(dem_wall_search_gather(s, w, k, local_x, reach));
        }
    }
    sort_by_facet(s, w, first);
    for (size_t c = first; c < s->candidates; c++)
    {
        const struct found f = found_at(s, w, c);
        const struct dem_triangle *const t = &w->triangle[f.triangle];
        const double *const x = dem_walls_to_frame(w, t->wall, p->x, local_x);

        if (w->wall[t->wall].absent)
        {
            continue;
        }
        if (!near || near->facet != f.facet ||
            memcmp(near->image, f.of_facet.n, sizeof near->image) != 0)
        {
            DEM_TRY(add_neighbor(s, particle, f.facet, 1, &near));
            near->first = (uint32_t)c;
            memcpy(near->image, f.of_facet.n, sizeof near->image);
        }
        near->count++;
        near->open &= (uint8_t)!rim_in_reach(
            t, dem_wall_from_candidate(s, w, (uint32_t)c, x, moved), reach);
    }
    return DEM_OK;
}

int dem_wall_search_find(struct dem_wall_search *s, const struct dem_walls *w,
                         const struct dem_particles *q, double skin)
{
    s->neighbors = s->candidates = 0;
    if (w->path_length > s->path_length)
    {
        DEM_TRY(dem_wall_search_prepare(s, w, s->radius));
    }
    for (size_t i = 0; i < q->n; i++)
    {
        DEM_TRY(find_primitives(s, w, &q->record[i], (uint32_t)i, skin));
        if (w->triangles > 0)
        {
            DEM_TRY(find_triangulated(s, w, &q->record[i], (uint32_t)i, skin));
        }
    }
    return DEM_OK;
}

int dem_wall_search_is_clear(struct dem_wall_search *s, const struct dem_walls *w,
                             const struct dem_particle *q, int *clear)
{
    const size_t neighbors = s->neighbors, candidates = s->candidates;

    if (w->path_length > s->path_length)
    {
        DEM_TRY(dem_wall_search_prepare(s, w, s->radius));
    }
    DEM_TRY(find_primitives(s, w, q, 0, 0.0));
    if (w->triangles > 0)
    {
        DEM_TRY(find_triangulated(s, w, q, 0, 0.0));
    }
    *clear = s->neighbors == neighbors;
    s->neighbors = neighbors;
    s->candidates = candidates;
    return DEM_OK;
}

/* Distance [m] of a sphere from the facet of a wall at rest, and the unit normal towards it. */
static double distance_and_normal(const struct dem_wall_search *s, const struct dem_walls *w,
                                  const struct dem_wall_neighbor *near, const double x[3],
                                  double normal[3])
{
    const struct dem_facet *const r = &w->facet[near->facet];
    double point[3], away[3];

    if (dem_wall_neighbor_open(w, near))
    {
        const double h = dem_facet_height(r, dem_wall_from_facet(w, near, x, away), normal);
        const int behind = r->shape == DEM_SHAPE_TRIANGLES && h < 0.0;

        for (int k = 0; k < 3; k++)
        {
            normal[k] = behind ? -normal[k] : normal[k];
        }
        return behind ? -h : h;
    }
    const double distance = dem_wall_search_nearest(s, w, near, x, point, away);

    for (int k = 0; k < 3; k++)
    {
        normal[k] = distance > 0.0 ? away[k]/distance : 0.0;
    }
    return distance;
}

int dem_wall_search_push_out(struct dem_wall_search *s, const struct dem_walls *w,
                             struct dem_particle *q, int *pushed)
{
    const size_t neighbors = s->neighbors, candidates = s->candidates;
    double deepest = 0.0, move[3] = {0.0, 0.0, 0.0};

    DEM_TRY(find_primitives(s, w, q, 0, 0.0));
    if (w->triangles > 0)
    {
        DEM_TRY(find_triangulated(s, w, q, 0, 0.0));
    }
    for (size_t k = neighbors; k < s->neighbors; k++)
    {
        double normal[3] = {0.0, 0.0, 0.0};
        const double depth =
            w->wall[w->facet[s->neighbor[k].facet].wall].frame >= 0
                ? 0.0
                : q->radius - distance_and_normal(s, w, &s->neighbor[k], q->x, normal);

        for (int c = 0; c < 3 && depth > deepest; c++)
        {
            move[c] = depth*normal[c];
        }
        deepest = fmax(depth, deepest);
    }
    *pushed = deepest > 0.0;
    for (int c = 0; c < 3; c++)
    {
        q->x[c] += move[c];
    }
    s->neighbors = neighbors;
    s->candidates = candidates;
    return DEM_OK;
}

uint32_t dem_wall_neighbor_candidate(const struct dem_wall_search *s, const struct dem_walls *w,
                                     const struct dem_wall_neighbor *near, const double x[3])
{
    uint32_t nearest = near->first;
    double best = INFINITY, on[3], moved[3];

    for (uint32_t c = near->first; c < near->first + near->count; c++)
    {
        const double square =
            dem_triangle_nearest(&w->triangle[s->candidate[c]],
                                 dem_wall_from_candidate(s, w, c, x, moved), on);

        if (square < best)
        {
            best = square;
            nearest = c;
        }
    }
    return nearest;
}
