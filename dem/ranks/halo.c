/*
 * halo.c -- builds the ghosts: selects the particles that other ranks need and exchanges their
 * records.
 *
 * Refreshing is in halo_refresh.c, migration in halo_migrate.c, the neighbor ranks in
 * halo_neighbors.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "ranks/halo.h"
#include "core/memory.h"
#include <math.h>
#include <string.h>

enum
{
    RECORD = (int)(sizeof(struct dem_particle)/sizeof(double)) /* doubles of a record */
};
_Static_assert(
    (int)DEM_HALO_WIDTH <= (int)RECORD,
    "a refresh is no longer than the message that built the ghosts, whose length is checked");

void dem_halo_init(struct dem_halo *h, struct dem_decomposition *decomposition)
{
    memset(h, 0, sizeof *h);
    h->decomposition = decomposition;
}

void dem_halo_free(struct dem_halo *h)
{
    dem_messages_free(&h->out);
    dem_messages_free(&h->in);
    for (int k = 0; k < DEM_HALO_SETS; k++)
    {
        dem_memory_free(h->send[k].start);
        dem_memory_free(h->send[k].index);
        dem_memory_free(h->receive[k].start);
        dem_memory_free(h->receive[k].index);
    }
    dem_memory_free(h->neighbor);
    dem_memory_free(h->send_rank);
    dem_memory_free(h->receive_rank);
    dem_memory_free(h->needed_here);
    dem_memory_free(h->needed_there);
    dem_memory_free(h->send_buffer);
    dem_memory_free(h->receive_buffer);
    dem_memory_free(h->request);
    memset(h, 0, sizeof *h);
}

/* ---- selection ------------------------------------------------------------------------------- */

/* As box_in_reach below, in a sheared domain: its images are not a product of axes. */
static int sheared_in_reach(const struct dem_domain *d, const double x[3], const double min[3],
                            const double max[3], double reach)
{
    double shift[DEM_SHIFTS][4];
    int near = 0;

    dem_domain_shifts(d, shift);
    for (int code = 0; code < DEM_SHIFTS; code++)
    {
        double square = 0.0;

        for (int k = 0; k < 3; k++)
        {
            const double y = x[k] + shift[code][k], gap = fmax(0.0, fmax(min[k] - y, y - max[k]));

            square += gap*gap;
        }
        near |= dem_domain_has_shift(d, code) && square < reach*reach;
    }
    return near;
}

/* 1 when some periodic image of x lies within `reach` of the box. */
static int box_in_reach(const struct dem_domain *d, const double x[3], const double min[3],
                        const double max[3], double reach)
{
    double square = 0.0;

    if (d->offset != 0.0)
    {
        return sheared_in_reach(d, x, min, max, reach);
    }
    for (int k = 0; k < 3; k++)
    {
        double nearest = INFINITY;

        for (int s = -d->periodic[k]; s <= d->periodic[k]; s++)
        {
            const double y = x[k] + s*d->length[k], gap = fmax(0.0, fmax(min[k] - y, y - max[k]));

            nearest = gap < nearest ? gap : nearest;    /* fmin: gcc 12 for aarch64 crashes */
        }
        square += nearest*nearest;
    }
    return square < reach*reach;
}

/* ---- messages that build ghosts: records, then columns of the same particles ------------------ */

static size_t ghost_doubles(const struct dem_particles *p)
{
    return RECORD + (size_t)p->ghost_step.n + (size_t)p->ghost_window.n;
}

static double *pack_columns(const struct dem_particles *p, const struct dem_column_list *list,
                            const uint32_t *index, size_t count, double *out)
{
    for (int k = 0; k < list->n; k++)
    {
        const double *const column = p->column[list->column[k]].data;

        for (size_t i = 0; i < count; i++)
        {
            *out++ = column[index[i]];
        }
    }
    return out;
}

static const double *unpack_columns(struct dem_particles *p, const struct dem_column_list *list,
                                    size_t first, size_t count, const double *in)
{
    for (int k = 0; k < list->n; k++, in += count)
    {
        memcpy(p->column[list->column[k]].data + first, in, count*sizeof *in);
    }
    return in;
}

static int select_ghosts(struct dem_halo *h, const struct dem_particles *p,
                         const struct dem_domain *d, double max_radius, double reach)
{
    struct dem_halo_route *const all = &h->send[DEM_HALO_ALL];
    double box[2][3], *out;
    size_t count = 0;

    h->send_ranks = 0;
    dem_messages_clear(&h->out);
    DEM_TRY(dem_halo_find_neighbors(h, d, 2.0*max_radius + reach + 2.0*h->clump_reach));
    for (int k = 0; k < h->neighbors; k++)
    {
        const int to_rank = h->neighbor[k];
        const size_t first = count;

        dem_halo_box(h, d, to_rank, box);
        for (size_t i = 0; i < p->n; i++)
        {
            if (box_in_reach(d, p->record[i].x, box[0], box[1],
                             p->record[i].radius + max_radius + reach + h->clump_reach))
            {
                DEM_TRY(DEM_GROW(all->index, all->capacity, count + 1));
                all->index[count++] = (uint32_t)i;
            }
        }
        if (count > first)
        {
            DEM_TRY(DEM_GROW(h->send_rank, h->send_rank_capacity, h->send_ranks + 1));
            DEM_TRY(DEM_GROW(all->start, all->start_capacity, h->send_ranks + 2));
            h->send_rank[h->send_ranks] = to_rank;
            all->start[h->send_ranks] = first;
            all->start[++h->send_ranks] = count;
            DEM_TRY(dem_messages_begin(&h->out, to_rank));
            DEM_TRY(dem_messages_extend(&h->out, (count - first)*ghost_doubles(p), &out));
            for (size_t i = first; i < count; i++, out += RECORD)
            {
                memcpy(out, &p->record[all->index[i]], sizeof *p->record);
            }
            out = pack_columns(p, &p->ghost_step, all->index + first, count - first, out);
            (void)pack_columns(p, &p->ghost_window, all->index + first, count - first, out);
        }
    }
    return DEM_GROW(h->send_buffer, h->send_capacity, count*dem_halo_width(p) + 1);
}

static int read_ghosts(struct dem_halo *h, struct dem_particles *p)
{
    struct dem_halo_route *const all = &h->receive[DEM_HALO_ALL];

    p->ghosts = 0;
    h->receive_ranks = h->in.ranks;
    DEM_TRY(DEM_GROW(h->receive_rank, h->receive_rank_capacity, h->receive_ranks + 1));
    DEM_TRY(DEM_GROW(all->start, all->start_capacity, h->receive_ranks + 2));
    for (int k = 0; k < h->in.ranks; k++)
    {
        const double *const data = h->in.data + h->in.start[k];
        const size_t count = (h->in.start[k + 1] - h->in.start[k])/ghost_doubles(p),
                     first = p->n + p->ghosts;
        const double *at = data + count*RECORD;

        DEM_TRY(dem_particles_grow(p, first + count));
        memcpy(&p->record[first], data, count*sizeof *p->record);
        at = unpack_columns(p, &p->ghost_step, first, count, at);
        (void)unpack_columns(p, &p->ghost_window, first, count, at);
        h->receive_rank[k] = h->in.rank[k];
        all->start[k] = p->ghosts;
        p->ghosts += count;
        all->start[k + 1] = p->ghosts;
    }
    DEM_TRY(DEM_GROW(all->index, all->capacity, p->ghosts + 1));
    for (size_t k = 0; k < p->ghosts; k++)
    {
        all->index[k] = (uint32_t)k;
    }
    DEM_TRY(DEM_GROW(h->request, h->request_capacity, h->send_ranks + h->receive_ranks + 1));
    return DEM_GROW(h->receive_buffer, h->receive_capacity, p->ghosts*dem_halo_width(p) + 1);
}

int dem_halo_build(struct dem_halo *h, int status, struct dem_particles *p,
                   const struct dem_domain *d, double max_radius, double reach)
{
    p->ghosts = 0;
    h->reach = reach;
    if (h->decomposition->ranks == 1)
    {
        return status;
    }
    status = status ? status : select_ghosts(h, p, d, max_radius, reach);
    DEM_TRY(dem_messages_exchange(h->decomposition->comm, status, &h->out, &h->in));
    return read_ghosts(h, p);
}
