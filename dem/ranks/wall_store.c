/*
 * wall_store.c -- slices of the sorted triangles, and the selection of those near a subdomain.
 *
 * A triangle is near a rank when its bounding box comes within reach of the rank's subdomain and of
 * the bounding box of all particles along every axis. Ranks are found down the tree of planes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "ranks/wall_store.h"
#include "core/memory.h"
#include "core/sort.h"
#include "ranks/collect.h"
#include "ranks/mpi_error.h"
#include <math.h>
#include <string.h>

enum
{
    RECORD = (int)(sizeof(struct dem_wall_record)/sizeof(double)), /* doubles of a record */
    FACTS = 11                                           /* numbers of a wall; a box has 6 */
};
_Static_assert(sizeof(struct dem_wall_record)%sizeof(double) == 0,
               "the record of a triangle is sent as doubles");

/* A selection reaches this much farther than needed, so that one serves many rebuilds. */
static const double wider = 2.0;

void dem_wall_store_init(struct dem_wall_store *s, struct dem_decomposition *d)
{
    s->decomposition = d;
}

void dem_wall_store_free(struct dem_wall_store *s)
{
    dem_memory_free(s->record);
    dem_messages_free(&s->out);
    dem_messages_free(&s->in);
    memset(s, 0, sizeof *s);
}

size_t dem_wall_store_bytes(const struct dem_wall_store *s, const struct dem_walls *w)
{
    return s->n*sizeof *s->record + (s->out.data_capacity + s->in.data_capacity)*sizeof(double) +
           w->triangle_capacity*sizeof *w->triangle + w->facet_capacity*sizeof *w->facet +
           (w->trajectory ? w->triangles*sizeof *w->trajectory : 0);
}

void dem_wall_store_expire(struct dem_wall_store *s)
{
    s->reach = 0.0;
}

/* ---- set-up ---------------------------------------------------------------------------------- */

void dem_wall_store_begin(struct dem_wall_store *s, struct dem_walls *w, int everywhere)
{
    s->first_only = s->decomposition->ranks > 1 && !everywhere;
    w->elsewhere = s->first_only && s->decomposition->rank > 0;
}

/* Collective. The messages of `out` and their memory are not needed any more. */
static int exchange(struct dem_wall_store *s, int status)
{
    status = dem_messages_exchange(s->decomposition->comm, status, &s->out, &s->in);
    dem_messages_clear(&s->out);
    dem_memory_free(s->out.data);
    s->out.data = NULL;
    s->out.data_capacity = 0;
    return status;
}

static void drop_received(struct dem_wall_store *s)
{
    dem_messages_clear(&s->in);
    dem_memory_free(s->in.data);
    s->in.data = NULL;
    s->in.data_capacity = 0;
}

static int add_everywhere(struct dem_wall_store *s, struct dem_walls *w, int wall, size_t n,
                          const double *corners)
{
    const struct dem_collect_items own = {"triangles of a wall (make it of several)", corners, n,
                                          9*sizeof *corners};
    void *all;

    DEM_TRY(dem_collect_gather(s->decomposition, DEM_OK, &own, &all, &n));
    const int status = dem_walls_add_triangles(w, wall, n, all);

    dem_memory_free(all);
    return dem_collect_agree(s->decomposition, status);
}

int dem_wall_store_add(struct dem_wall_store *s, struct dem_walls *w, int wall, size_t n,
                       const double *corners)
{
    int status = DEM_OK;
    double *to;

    if (!s->first_only)
    {
        return add_everywhere(s, w, wall, n, corners);
    }
    if (n > 0)
    {
        status = dem_messages_begin(&s->out, 0);
        status = status ? status : dem_messages_extend(&s->out, 9*n, &to);
        if (!status)
        {
            memcpy(to, corners, 9*n*sizeof *to);
        }
    }
    DEM_TRY(exchange(s, status));
    n = s->in.ranks > 0 ? s->in.start[s->in.ranks]/9 : 0;
    status = dem_walls_add_triangles(w, wall, n, s->in.data);
    drop_received(s);
    return dem_collect_agree(s->decomposition, status);
}

/* From the walls, or back to them. */
static void copy_facts(struct dem_walls *w, double *fact, int back)
{
    for (int k = 0; k < w->walls; k++, fact += FACTS)
    {
        struct dem_wall *const of = &w->wall[k];
        const double facts[FACTS] = {(double)of->triangles, (double)of->flat, (double)of->repeats,
                                     (double)of->given, of->first_facet, of->facets, of->push,
                                     of->area, of->centroid[0], of->centroid[1],
                                     of->centroid[2]};

        if (!back)
        {
            memcpy(fact, facts, sizeof facts);
            continue;
        }
        of->triangles = (size_t)fact[0];
        of->flat = (size_t)fact[1];
        of->repeats = (size_t)fact[2];
        of->given = (size_t)fact[3];
        of->first_facet = (int)fact[4];
        of->facets = (int)fact[5];
        of->push = fact[6];
        of->area = fact[7];
        memcpy(of->centroid, fact + 8, sizeof of->centroid);
    }
    for (int k = 0; k < w->frames; k++, fact += FACTS)
    {
        memcpy(back ? &w->frame[k].box[0][0] : fact, back ? fact : &w->frame[k].box[0][0],
               sizeof w->frame[k].box);
    }
    *fact = back ? *fact : (double)w->all_flat_static;
    w->all_flat_static = back ? (int)*fact : w->all_flat_static;
}

int dem_wall_store_finish(struct dem_wall_store *s, int status, struct dem_walls *w)
{
    const int n = FACTS*(w->walls + w->frames) + 1;
    double *fact = NULL;

    if (!s->first_only)
    {
        return status;
    }
    status = status ? status : DEM_NEW(fact, n);
    status = dem_collect_agree(s->decomposition, status);
    if (!status)
    {
        copy_facts(w, fact, 0);
        status = DEM_MPI_STATUS(MPI_Bcast(fact, n, MPI_DOUBLE, 0, s->decomposition->comm));
        copy_facts(w, fact, 1);
    }
    dem_memory_free(fact);
    dem_walls_choose_periods(w);
    status = status ? status : dem_walls_make_marks(w);
    return dem_collect_agree(s->decomposition, status);
}

static size_t slice_begin(const struct dem_wall_store *s, size_t all, int rank)
{
    return (size_t)((double)all*rank/s->decomposition->ranks);
}

/* Messages with the slices of `all` triangles of this rank for the ranks [from, to). */
static int write_slices(struct dem_wall_store *s, const struct dem_walls *w, size_t all, int from,
                        int to)
{
    for (int rank = from; rank < to; rank++)
    {
        const size_t begin = slice_begin(s, all, rank), end = slice_begin(s, all, rank + 1);
        double *data;

        DEM_TRY(dem_messages_begin(&s->out, rank));
        DEM_TRY(dem_messages_extend(&s->out, RECORD*(end - begin), &data));
        for (size_t t = begin; t < end; t++, data += RECORD)
        {
            struct dem_wall_record record;

            dem_walls_record(w, t, &record);
            memcpy(data, &record, sizeof record);
        }
    }
    return DEM_OK;
}

int dem_wall_store_distribute(struct dem_wall_store *s, struct dem_walls *w)
{
    const size_t all = dem_walls_count_triangles(w);
    const int me = s->decomposition->rank;
    int status = DEM_OK;

    if (s->decomposition->ranks == 1 || all == 0)
    {
        return DEM_OK;
    }
    if (!w->elsewhere)
    {
        status = s->first_only ? write_slices(s, w, all, 0, s->decomposition->ranks)
                               : write_slices(s, w, all, me, me + 1);
    }
    status = status ? status : dem_walls_hold(w, 0, NULL);
    DEM_TRY(exchange(s, status));
    s->n = s->in.ranks > 0 ? s->in.start[s->in.ranks]/RECORD : 0;
    status = DEM_NEW(s->record, s->n + 1);
    if (!status && s->n > 0)
    {
        memcpy(s->record, s->in.data, s->n*sizeof *s->record);
    }
    drop_received(s);
    return dem_collect_agree(s->decomposition, status);
}

/* ---- selection ------------------------------------------------------------------------------- */

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
            DEM_TRY(dem_messages_extend(&s->out, RECORD, &data));
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
    DEM_TRY(exchange(s, status));
    status = dem_walls_hold(w, s->in.ranks > 0 ? s->in.start[s->in.ranks]/RECORD : 0,
                            (const struct dem_wall_record *)s->in.data);
    drop_received(s);
    return status;
}

/* ---- triangles for all ranks ----------------------------------------------------------------- */

/* Collective. The records of all ranks that `own` lists, on each rank. */
static int gather_records(const struct dem_decomposition *d, int status,
                          const struct dem_wall_record *own, size_t n,
                          struct dem_wall_record **records, size_t *number)
{
    const struct dem_collect_items items = {"triangles (make the wall of several)", own, n,
                                            sizeof *own};
    void *all = NULL;

    status = dem_collect_gather(d, status, &items, &all, number);
    *records = all;
    return status;
}

/* After n records, those for triangles of other walls at rest or in a reference frame. */
static int hold_besides(struct dem_walls *w, int wall, struct dem_wall_record *all, size_t n)
{
    for (size_t t = 0; t < w->triangles; t++)
    {
        if (w->triangle[t].wall != wall && !w->wall[w->triangle[t].wall].follows_mesh)
        {
            dem_walls_record(w, t, &all[n++]);
        }
    }
    return dem_walls_hold(w, n, all);
}

int dem_wall_store_follow(struct dem_wall_store *s, struct dem_walls *w, int wall)
{
    size_t first = 0, end, n;
    struct dem_wall_record *all;
    int status = DEM_OK;

    if (s->decomposition->ranks == 1 || w->wall[wall].follows_mesh)
    {
        return DEM_OK;
    }
    while (first < s->n && s->record[first].triangle.wall != wall)
    {
        first++;
    }
    for (end = first; end < s->n && s->record[end].triangle.wall == wall; end++)
    {
    }
    DEM_TRY(gather_records(s->decomposition, DEM_OK, s->record + first, end - first, &all, &n));
    status = DEM_RESIZE(all, n, n + w->triangles);
    status = status ? status : hold_besides(w, wall, all, n);
    dem_memory_free(all);
    return dem_collect_agree(s->decomposition, status);
}

/* 1 when a box, or a periodic image of it, comes within reach of the other. */
static int meets_image(const struct dem_domain *d, double box[2][3], double other[2][3],
                       double reach)
{
    int meets = 1, range[2];

    for (int k = 0; k < 3; k++)
    {
        const double extent[2] = {box[0][k], box[1][k]},
                     around[2] = {other[0][k] - reach, other[1][k] + reach};

        dem_walls_image_range(d->length[k], extent, around, range);
        meets &= d->periodic[k] ? range[0] <= range[1]
                                : extent[0] <= around[1] && extent[1] >= around[0];
    }
    return meets;
}

int dem_wall_store_gather(const struct dem_wall_store *s, int status, const struct dem_walls *w,
                          const struct dem_domain *d, double box[2][3], double reach,
                          struct dem_walls *near)
{
    struct dem_wall_record *own = NULL, *all = NULL;
    size_t n = 0, total;

    *near = (struct dem_walls){.walls = 0};
    status = status ? status : DEM_NEW(own, s->n + 1);
    for (size_t t = 0; t < s->n && !status; t++)
    {
        double here[2][3];

        dem_walls_triangle_box(w, &s->record[t].triangle, here);
        if (!w->wall[s->record[t].triangle.wall].follows_mesh &&
            meets_image(d, box, here, reach))
        {
            own[n++] = s->record[t];
        }
    }
    status = gather_records(s->decomposition, status, own, n, &all, &total);
    dem_memory_free(own);
    DEM_TRY(status);
    status = dem_walls_copy_part(w, total, all, near);
    dem_memory_free(all);
    return status;
}

/* ---- output ---------------------------------------------------------------------------------- */

static int write_corners(struct dem_wall_store *s, int wall)
{
    double *data;

    DEM_TRY(dem_messages_begin(&s->out, 0));
    for (size_t t = 0; t < s->n; t++)
    {
        if (s->record[t].triangle.wall == wall)
        {
            DEM_TRY(dem_messages_extend(&s->out, 9, &data));
            memcpy(data, s->record[t].triangle.corner, 9*sizeof *data);
        }
    }
    return DEM_OK;
}

/* From the frame of the wall to the global frame. */
static void to_global(const struct dem_walls *w, int wall, size_t n, const double *from, double *to)
{
    const int frame = w->wall[wall].frame;

    memcpy(to, from, 9*n*sizeof *to);
    for (size_t k = 0; k < 3*n && frame >= 0; k++)
    {
        dem_pose_point(&w->frame[frame].pose, from + 3*k, to + 3*k);
    }
}

int dem_wall_store_corners(struct dem_wall_store *s, const struct dem_walls *w, int wall,
                           double *corners)
{
    if (s->decomposition->ranks == 1 || w->wall[wall].follows_mesh)
    {
        for (size_t t = 0; t < w->triangles && s->decomposition->rank == 0; t++)
        {
            if (w->triangle[t].wall == wall)
            {
                to_global(w, wall, 1, &w->triangle[t].corner[0][0], corners);
                corners += 9;
            }
        }
        return DEM_OK;
    }
    DEM_TRY(exchange(s, write_corners(s, wall)));
    if (s->in.ranks > 0)
    {
        to_global(w, wall, s->in.start[s->in.ranks]/9, s->in.data, corners);
    }
    drop_received(s);
    return DEM_OK;
}
