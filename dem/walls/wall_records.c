/*
 * wall_records.c -- the part of the walls' triangles, with their facets, that this rank holds.
 *
 * Triangles are held in the order of their global index, and facets in the order of their numbers,
 * so a search meets the same triangles in the same order whatever else a rank holds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "walls/walls.h"
#include <math.h>
#include <string.h>

void dem_walls_triangle_box(const struct dem_walls *w, const struct dem_triangle *t,
                            double box[2][3])
{
    const int frame = w->wall[t->wall].frame;

    for (int k = 0; k < 3; k++)
    {
        double corner[3];

        memcpy(corner, t->corner[k], sizeof corner);
        if (frame >= 0)
        {
            dem_pose_point(&w->frame[frame].pose, t->corner[k], corner);
        }
        for (int a = 0; a < 3; a++)
        {
            box[0][a] = k > 0 ? fmin(box[0][a], corner[a]) : corner[a];
            box[1][a] = k > 0 ? fmax(box[1][a], corner[a]) : corner[a];
        }
    }
}

size_t dem_walls_find(const struct dem_walls *w, uint32_t index)
{
    size_t from = 0, to = w->triangles;

    if (index < to && w->triangle[index].index == index)    /* all are held */
    {
        return index;
    }
    while (from < to)
    {
        const size_t middle = from + (to - from)/2;

        from = w->triangle[middle].index < index ? middle + 1 : from;
        to = w->triangle[middle].index < index ? to : middle;
    }
    return from;
}

void dem_walls_record(const struct dem_walls *w, size_t triangle, struct dem_wall_record *r)
{
    const struct dem_facet *const f = &w->facet[w->triangle[triangle].facet];

    *r = (struct dem_wall_record){.triangle = w->triangle[triangle],
                                  .offset = f->offset,
                                  .largest = f->largest,
                                  .bent = f->bent,
                                  .endless = f->endless,
                                  .distinct = f->distinct};
    r->triangle.facet = f->number;
    memcpy(r->normal, f->normal, sizeof r->normal);
}

/* ---- another part ---------------------------------------------------------------------------- */

/* An item is a record, or behind these a triangle held. */
static struct dem_triangle item_triangle(const struct dem_walls *w, size_t n,
                                         const struct dem_wall_record *record, size_t item)
{
    struct dem_triangle t = item < n ? record[item].triangle : w->triangle[item - n];

    t.facet = item < n ? t.facet : w->facet[t.facet].number;
    return t;
}

/* The facets of the items, sorted by number, behind those without triangles. */
static int make_facets(const struct dem_walls *w, size_t n, const struct dem_wall_record *record,
                       const struct dem_sort_pair *by_facet, struct dem_walls *h)
{
    int first = 0, distinct = 0;

    while (first < w->facets && w->facet[first].shape != DEM_SHAPE_TRIANGLES)
    {
        first++;
    }
    for (size_t k = 0; k < h->triangles; k++)
    {
        distinct += k == 0 || by_facet[k].hi != by_facet[k - 1].hi;
    }
    DEM_TRY(DEM_NEW(h->facet, first + distinct + 1));
    h->facet_capacity = (size_t)(first + distinct) + 1;
    h->facets = first;
    if (first > 0)
    {
        memcpy(h->facet, w->facet, (size_t)first*sizeof *h->facet);
    }
    for (size_t k = 0; k < h->triangles; k++)
    {
        const size_t item = by_facet[k].lo;

        if (k == 0 || by_facet[k].hi != by_facet[k - 1].hi)
        {
            struct dem_facet *const f = &h->facet[h->facets++];

            if (item >= n)
            {
                *f = w->facet[w->triangle[item - n].facet];
                continue;
            }
            *f = (struct dem_facet){.offset = record[item].offset,
                                    .wall = record[item].triangle.wall,
                                    .number = record[item].triangle.facet,
                                    .bent = record[item].bent,
                                    .endless = record[item].endless,
                                    .distinct = record[item].distinct,
                                    .largest = record[item].largest};
            memcpy(f->normal, record[item].normal, sizeof f->normal);
            memcpy(f->centre, record[item].triangle.corner[0], sizeof f->centre);
        }
    }
    return DEM_OK;
}

/* Triangles by index, with the facets that have been made. */
static int make_triangles(const struct dem_walls *w, size_t n, const struct dem_wall_record *record,
                          const struct dem_sort_pair *by_index, struct dem_walls *h)
{
    DEM_TRY(DEM_NEW(h->triangle, h->triangles + 1));
    DEM_TRY(w->trajectory ? DEM_NEW(h->trajectory, h->triangles + 1) : DEM_OK);
    for (size_t k = 0; k < h->triangles; k++)
    {
        const size_t item = by_index[k].lo;
        struct dem_triangle *const t = &h->triangle[k];

        *t = item_triangle(w, n, record, item);
        t->facet = (int)by_index[k].index;
        if (w->trajectory && item >= n)
        {
            h->trajectory[k] = w->trajectory[item - n];
        }
        else if (w->trajectory)
        {
            memcpy(h->trajectory[k].from, t->corner, sizeof t->corner);
            memcpy(h->trajectory[k].to, t->corner, sizeof t->corner);
        }
    }
    return DEM_OK;
}

/* order, scratch: of h->triangles items. */
static int make_part(const struct dem_walls *w, size_t n, const struct dem_wall_record *record,
                     struct dem_sort_pair *order, struct dem_sort_pair *scratch, struct dem_walls *h)
{
    size_t items = 0;
    int facet = -1;

    for (size_t item = 0; item < n + w->triangles; item++)
    {
        if (item < n || w->wall[w->triangle[item - n].wall].follows_mesh)
        {
            const struct dem_triangle t = item_triangle(w, n, record, item);

            order[items++] = (struct dem_sort_pair){.hi = (uint64_t)t.facet, .lo = item};
        }
    }
    dem_sort_pairs(order, h->triangles, scratch);
    DEM_TRY(make_facets(w, n, record, order, h));
    facet = h->facets;
    for (size_t k = h->triangles; k-- > 0;)
    {
        facet -= k + 1 == h->triangles || order[k].hi != order[k + 1].hi;
        scratch[k].index = (uint32_t)facet;
    }
    for (size_t k = 0; k < h->triangles; k++)
    {
        const size_t item = order[k].lo;

        order[k] = (struct dem_sort_pair){.hi = item_triangle(w, n, record, item).index,
                                          .lo = item,
                                          .index = scratch[k].index};
    }
    dem_sort_pairs(order, h->triangles, scratch);
    return make_triangles(w, n, record, order, h);
}

int dem_walls_copy_part(const struct dem_walls *w, size_t n, const struct dem_wall_record *record,
                        struct dem_walls *part)
{
    struct dem_sort_pair *order = NULL, *scratch = NULL;

    *part = *w;
    part->triangle = NULL;
    part->trajectory = NULL;
    part->facet = NULL;
    part->triangles = n;
    for (size_t t = 0; t < w->triangles; t++)
    {
        part->triangles += w->wall[w->triangle[t].wall].follows_mesh != 0;
    }
    int status = DEM_NEW(order, part->triangles + 1);

    status = status ? status : DEM_NEW(scratch, part->triangles + 1);
    status = status ? status : make_part(w, n, record, order, scratch, part);
    dem_memory_free(order);
    dem_memory_free(scratch);
    if (status)
    {
        dem_walls_free_part(part);
    }
    part->triangle_capacity = part->triangles + 1;
    return status;
}

void dem_walls_free_part(struct dem_walls *part)
{
    dem_memory_free(part->triangle);
    dem_memory_free(part->trajectory);
    dem_memory_free(part->facet);
    part->triangle = NULL;
    part->trajectory = NULL;
    part->facet = NULL;
    part->triangles = 0;
    part->facets = 0;
}

int dem_walls_hold(struct dem_walls *w, size_t n, const struct dem_wall_record *record)
{
    struct dem_walls part;

    DEM_TRY(dem_walls_copy_part(w, n, record, &part));
    dem_walls_free_part(w);
    *w = part;
    return DEM_OK;
}
