/*
 * wall_store_select.c -- the selection of the triangles near a subdomain.
 *
 * A triangle is near a rank when its bounding box comes within reach of the rank's subdomain and of
 * the bounding box of all particles along every axis. Ranks are found down the tree of planes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "ranks/wall_store.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "ranks/collect.h"
#include <math.h>
#include <string.h>

/* A selection reaches this much farther than needed, so that one serves many rebuilds. */
static const double wider = 2.0;

struct selected                   /* a record for a rank: hi = 0, lo = rank */
{
    size_t n, capacity;
    struct dem_sort_pair *pair;
};

/* Append the ranks of [lo, hi) whose subdomains come within reach of the box. */
static int descend(const struct dem_wall_store *s, double box[2][3], int lo, int hi,
                   uint32_t record, struct selected *list)
{
    const int mid = (lo + hi)/2;

    if (hi - lo == 1)
    {
        DEM_TRY(DEM_GROW(list->pair, list->capacity, list->n + 1));
        list->pair[list->n++] = (struct dem_sort_pair){.lo = (uint64_t)lo, .index = record};
        return DEM_OK;
    }
    const double plane = s->decomposition->at[mid];
    const int axis = s->decomposition->axis[mid];

    DEM_TRY(box[0][axis] - s->reach <= plane ? descend(s, box, lo, mid, record, list) : DEM_OK);
    return box[1][axis] + s->reach >= plane ? descend(s, box, mid, hi, record, list) : DEM_OK;
}

/* 1 when two boxes come within reach of each other along every axis. */
static int boxes_meet(double a[2][3], double b[2][3], double reach)
{
    int meet = 1;

    for (int k = 0; k < 3; k++)
    {
        meet &= a[0][k] <= b[1][k] + reach && a[1][k] >= b[0][k] - reach;
    }
    return meet;
}

/* The ranks near an image of a triangle, `n` periods off. */
static int select_image(struct dem_wall_store *s, const double period[3], double box[2][3],
                        const int n[3], uint32_t record, struct selected *list)
{
    double image[2][3];

    for (int k = 0; k < 6; k++)
    {
        image[k/3][k%3] = box[k/3][k%3] + n[k%3]*period[k%3];
    }
    return boxes_meet(image, s->box, s->reach)
               ? descend(s, image, 0, s->decomposition->ranks, record, list)
               : DEM_OK;
}

static int select_record(struct dem_wall_store *s, const struct dem_walls *w, uint32_t record,
                         struct selected *list)
{
    const struct dem_triangle *const triangle = &s->record[record].triangle;
    const double *const period = dem_walls_period(w, w->wall[triangle->wall].frame);
    double box[2][3];
    int range[3][2], n[3];

    dem_walls_triangle_box(w, triangle, box);
    for (int k = 0; k < 3; k++)
    {
        dem_walls_image_range(period[k], (const double[2]){box[0][k], box[1][k]},
                              (const double[2]){s->box[0][k] - s->reach, s->box[1][k] + s->reach},
                              range[k]);
    }
    for (n[0] = range[0][0]; n[0] <= range[0][1]; n[0]++)
    {
        for (n[1] = range[1][0]; n[1] <= range[1][1]; n[1]++)
        {
            for (n[2] = range[2][0]; n[2] <= range[2][1]; n[2]++)
            {
                DEM_TRY(select_image(s, period, box, n, record, list));
            }
        }
    }
    return DEM_OK;
}

static int select_records(struct dem_wall_store *s, const struct dem_walls *w,
                          struct selected *list)
{
    for (size_t t = 0; t < s->n; t++)
    {
        if (!w->wall[s->record[t].triangle.wall].follows_mesh)
        {
            DEM_TRY(select_record(s, w, (uint32_t)t, list));
        }
    }
    return DEM_OK;
}

/* Each record once to each rank, whatever images of it are near. */
static int write_messages(struct dem_wall_store *s, const struct selected *list)
{
    double *data;

    for (size_t k = 0; k < list->n; k++)
    {
        const struct dem_sort_pair *const here = &list->pair[k], *const before = here - (k > 0);

        if (k == 0 || here->lo != before->lo)
        {
            DEM_TRY(dem_messages_begin(&s->out, (int)here->lo));
        }
        if (k == 0 || here->lo != before->lo || here->index != before->index)
        {
            DEM_TRY(dem_messages_extend(&s->out, DEM_WALL_STORE_RECORD, &data));
            memcpy(data, &s->record[here->index], sizeof *s->record);
        }
    }
    return DEM_OK;
}

static int address(struct dem_wall_store *s, const struct dem_walls *w)
{
    struct selected list = {.n = 0};
    struct dem_sort_pair *scratch = NULL;
    int status = select_records(s, w, &list);

    status = status ? status : DEM_NEW(scratch, list.n + 1);
    if (!status)
    {
        dem_sort_pairs(list.pair, list.n, scratch);
        dem_memory_free(scratch);
        status = write_messages(s, &list);
    }
    dem_memory_free(list.pair);
    return status;
}

/* Bounding box of the particles of all ranks; without particles it is inside out. */
static void bounding_box(const struct dem_wall_store *s, const struct dem_particles *p,
                         double box[2][3])
{
    double max[6];

    for (int k = 0; k < 6; k++)
    {
        max[k] = -INFINITY;
    }
    for (size_t i = 0; i < p->n; i++)
    {
        for (int k = 0; k < 3; k++)
        {
            max[k] = fmax(max[k], -p->record[i].x[k]);
            max[k + 3] = fmax(max[k + 3], p->record[i].x[k]);
        }
    }
    dem_collect_max_double(s->decomposition, max, 6);
    for (int k = 0; k < 3; k++)
    {
        box[0][k] = -max[k];
        box[1][k] = max[k + 3];
    }
}

/* By how much box b extends beyond a [m]. */
static double excess(double a[2][3], double b[2][3])
{
    double largest = 0.0;

    for (int k = 0; k < 3; k++)
    {
        largest = fmax(largest, fmax(a[0][k] - b[0][k], b[1][k] - a[1][k]));
    }
    return largest;
}

int dem_wall_store_select(struct dem_wall_store *s, int status, struct dem_walls *w,
                          const struct dem_particles *p, double reach, int *changed)
{
    static const double rest[3] = {0.0, 0.0, 0.0};
    double box[2][3];

    *changed = 0;
    if (s->decomposition->ranks == 1 || dem_walls_count_triangles(w) == 0)
    {
        return status;
    }
    bounding_box(s, p, box);
    if (reach + excess(s->box, box) + dem_walls_max_displacement(w, DEM_LIST_TRIANGLES, rest) <=
        s->reach)
    {
        return status;
    }
    memcpy(s->box, box, sizeof box);
    s->reach = wider*reach;
    s->selections++;
    dem_walls_reset_marks(w, DEM_LIST_TRIANGLES);
    *changed = 1;
    status = status ? status : address(s, w);
    DEM_TRY(dem_wall_store_exchange(s, status));
    status = dem_walls_hold(w, s->in.ranks > 0 ? s->in.start[s->in.ranks]/DEM_WALL_STORE_RECORD : 0,
                            (const struct dem_wall_record *)s->in.data);
    dem_wall_store_drop_received(s);
    return status;
}
