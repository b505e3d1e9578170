/*
 * wall_store.c -- slices of the sorted triangles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "ranks/wall_store.h"
#include "core/memory.h"
#include "ranks/collect.h"
#include "ranks/mpi_error.h"
#include <string.h>

enum
{
    FACTS = 11    /* numbers of a wall; a box has 6 */
};

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

int dem_wall_store_exchange(struct dem_wall_store *s, int status)
{
    status = dem_messages_exchange(s->decomposition->comm, status, &s->out, &s->in);
    dem_messages_clear(&s->out);
    dem_memory_free(s->out.data);
    s->out.data = NULL;
    s->out.data_capacity = 0;
    return status;
}

void dem_wall_store_drop_received(struct dem_wall_store *s)
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
    DEM_TRY(dem_wall_store_exchange(s, status));
    n = s->in.ranks > 0 ? s->in.start[s->in.ranks]/9 : 0;
    status = dem_walls_add_triangles(w, wall, n, s->in.data);
    dem_wall_store_drop_received(s);
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
        DEM_TRY(dem_messages_extend(&s->out, DEM_WALL_STORE_RECORD*(end - begin), &data));
        for (size_t t = begin; t < end; t++, data += DEM_WALL_STORE_RECORD)
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
    DEM_TRY(dem_wall_store_exchange(s, status));
    s->n = s->in.ranks > 0 ? s->in.start[s->in.ranks]/DEM_WALL_STORE_RECORD : 0;
    status = DEM_NEW(s->record, s->n + 1);
    if (!status && s->n > 0)
    {
        memcpy(s->record, s->in.data, s->n*sizeof *s->record);
    }
    dem_wall_store_drop_received(s);
    return dem_collect_agree(s->decomposition, status);
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
    DEM_TRY(dem_wall_store_exchange(s, write_corners(s, wall)));
    if (s->in.ranks > 0)
    {
        to_global(w, wall, s->in.start[s->in.ranks]/9, s->in.data, corners);
    }
    dem_wall_store_drop_received(s);
    return DEM_OK;
}
