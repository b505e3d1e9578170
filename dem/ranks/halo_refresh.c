/*
 * halo_refresh.c -- refreshes the ghosts in each step: either all, or those that the step needs.
 *
 * Ghosts are selected by the outer skin. A step needs far fewer: those with contact rows. After a
 * prune each rank therefore tells the owners which ghosts it needs, by one byte per ghost; both sides
 * know the ghosts and their order. All ghosts are refreshed only before the next prune.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/memory.h"
#include "ranks/collect.h"
#include "ranks/halo.h"
#include <string.h>

enum
{
    TAG_REFRESH = 72,
    TAG_NEEDED = 73
};

static size_t count_of(const struct dem_halo_route *r, int ranks)
{
    return ranks > 0 ? r->start[ranks] : 0;
}

/* ---- selection ------------------------------------------------------------------------------- */

static int reserve_route(struct dem_halo_route *needed, const struct dem_halo_route *all, int ranks)
{
    DEM_TRY(DEM_GROW(needed->start, needed->start_capacity, ranks + 2));
    return DEM_GROW(needed->index, needed->capacity, count_of(all, ranks) + 1);
}

int dem_halo_reserve_needed(struct dem_halo *h, const struct dem_particles *p)
{
    const struct dem_halo_route *const send = &h->send[DEM_HALO_ALL];
    const struct dem_halo_route *const receive = &h->receive[DEM_HALO_ALL];

    if (h->decomposition->ranks == 1)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_GROW(h->needed_here, h->needed_here_capacity, p->ghosts + 1));
    DEM_TRY(DEM_GROW(h->needed_there, h->needed_there_capacity, count_of(send, h->send_ranks) + 1));
    DEM_TRY(reserve_route(&h->send[DEM_HALO_NEEDED], send, h->send_ranks));
    return reserve_route(&h->receive[DEM_HALO_NEEDED], receive, h->receive_ranks);
}

static void mark_needed(struct dem_halo *h, const struct dem_particles *p,
                        const struct dem_contacts *c)
{
    memset(h->needed_here, 0, p->ghosts);
    for (uint32_t r = 0; r < c->rows.n; r++)
    {
        const struct dem_pair *const q =
            c->rows.pair[r] == DEM_ROW_NONE ? NULL : dem_contacts_pair(c, r);

        if (q && !q->wall && q->i >= p->n)
        {
            h->needed_here[q->i - p->n] = 1;
        }
        if (q && !q->wall && q->j >= p->n)
        {
            h->needed_here[q->j - p->n] = 1;
        }
    }
}

/* Count a request that a call has opened; record the error of a call that has not. */
static void open_request(struct dem_halo *h, const char *call, int code)
{
    if (code == MPI_SUCCESS)
    {
        h->open_requests++;
    }
    else
    {
        dem_collect_record(h->decomposition, call, code);
    }
}

static void exchange_needed(struct dem_halo *h)
{
    const size_t *const here = h->receive[DEM_HALO_ALL].start;
    const size_t *const there = h->send[DEM_HALO_ALL].start;

    for (int k = 0; k < h->send_ranks; k++)
    {
        open_request(h, "MPI_Irecv",
                     MPI_Irecv(h->needed_there + there[k], (int)(there[k + 1] - there[k]), MPI_BYTE,
                               h->send_rank[k], TAG_NEEDED, h->decomposition->comm,
                               &h->request[h->open_requests]));
    }
    for (int k = 0; k < h->receive_ranks; k++)
    {
        open_request(h, "MPI_Isend",
                     MPI_Isend(h->needed_here + here[k], (int)(here[k + 1] - here[k]), MPI_BYTE,
                               h->receive_rank[k], TAG_NEEDED, h->decomposition->comm,
                               &h->request[h->open_requests]));
    }
    dem_halo_wait(h);
}

/* Copy the needed entries of a route. */
static void copy_needed(struct dem_halo_route *needed, const struct dem_halo_route *all, int ranks,
                        const uint8_t *is_needed)
{
    size_t kept = 0;

    for (int k = 0; k < ranks; k++)
    {
        needed->start[k] = kept;
        for (size_t i = all->start[k]; i < all->start[k + 1]; i++)
        {
            needed->index[kept] = all->index[i];
            kept += is_needed[i];
        }
        needed->start[k + 1] = kept;
    }
}

void dem_halo_select_needed(struct dem_halo *h, const struct dem_particles *p,
                            const struct dem_contacts *c)
{
    if (h->decomposition->ranks == 1)
    {
        return;
    }
    mark_needed(h, p, c);
    dem_halo_select_marked(h);
}

void dem_halo_select_marked(struct dem_halo *h)
{
    exchange_needed(h);
    copy_needed(&h->send[DEM_HALO_NEEDED], &h->send[DEM_HALO_ALL], h->send_ranks,
                h->needed_there);
    copy_needed(&h->receive[DEM_HALO_NEEDED], &h->receive[DEM_HALO_ALL], h->receive_ranks,
                h->needed_here);
}

/* ---- refreshing ------------------------------------------------------------------------------ */

/* A count fits an int: the message that built these ghosts was larger. */
void dem_halo_post(struct dem_halo *h, enum dem_halo_set which, int width)
{
    const struct dem_halo_route *const to = &h->send[which], *const from = &h->receive[which];

    h->sent = which;
    for (int k = 0; k < h->receive_ranks; k++)
    {
        const int count = (int)(from->start[k + 1] - from->start[k])*width;

        if (count > 0)
        {
            open_request(h, "MPI_Irecv",
                         MPI_Irecv(h->receive_buffer + from->start[k]*(size_t)width, count,
                                   MPI_DOUBLE, h->receive_rank[k], TAG_REFRESH,
                                   h->decomposition->comm, &h->request[h->open_requests]));
        }
    }
    for (int k = 0; k < h->send_ranks; k++)
    {
        const int count = (int)(to->start[k + 1] - to->start[k])*width;

        if (count > 0)
        {
            open_request(h, "MPI_Isend",
                         MPI_Isend(h->send_buffer + to->start[k]*(size_t)width, count, MPI_DOUBLE,
                                   h->send_rank[k], TAG_REFRESH, h->decomposition->comm,
                                   &h->request[h->open_requests]));
            h->refresh_traffic.messages++;
            h->refresh_traffic.bytes += count*(int64_t)sizeof(double);
        }
    }
}

void dem_halo_wait(struct dem_halo *h)
{
    if (h->open_requests > 0)
    {
        dem_collect_record(h->decomposition, "MPI_Waitall",
                           MPI_Waitall(h->open_requests, h->request, MPI_STATUSES_IGNORE));
        h->open_requests = 0;
    }
}

/* `columns` is 0 where it is known at compile time that there are none. */
__attribute__((always_inline)) static inline void pack(struct dem_halo *h,
                                                       const struct dem_particles *p, size_t sent,
                                                       const uint32_t *index, const int columns)
{
    double *to = h->send_buffer;

    for (size_t k = 0; k < sent; k++, to += DEM_HALO_WIDTH + columns)
    {
        const struct dem_particle *const from = &p->record[index[k]];

        memcpy(to, from->x, sizeof from->x);
        memcpy(to + 3, from->v, sizeof from->v);
        memcpy(to + 6, from->w, sizeof from->w);
        for (int c = 0; c < columns; c++)
        {
            to[DEM_HALO_WIDTH + c] = p->column[p->ghost_step.column[c]].data[index[k]];
        }
    }
}

void dem_halo_send(struct dem_halo *h, const struct dem_particles *p, enum dem_halo_set which)
{
    const size_t sent = h->decomposition->ranks > 1 ? count_of(&h->send[which], h->send_ranks) : 0;

    if (p->ghost_step.n == 0)
    {
        pack(h, p, sent, h->send[which].index, 0);
    }
    else
    {
        pack(h, p, sent, h->send[which].index, p->ghost_step.n);
    }
    if (h->decomposition->ranks > 1)
    {
        dem_halo_post(h, which, DEM_HALO_WIDTH + p->ghost_step.n);
    }
}

__attribute__((always_inline)) static inline void unpack(const struct dem_halo *h,
                                                         struct dem_particles *p, size_t received,
                                                         const uint32_t *index, const int columns)
{
    const double *data = h->receive_buffer;

    for (size_t k = 0; k < received; k++, data += DEM_HALO_WIDTH + columns)
    {
        struct dem_particle *const to = &p->record[p->n + index[k]];

        memcpy(to->x, data, sizeof to->x);
        memcpy(to->v, data + 3, sizeof to->v);
        memcpy(to->w, data + 6, sizeof to->w);
        for (int c = 0; c < columns; c++)
        {
            p->column[p->ghost_step.column[c]].data[p->n + index[k]] = data[DEM_HALO_WIDTH + c];
        }
    }
}

void dem_halo_receive(struct dem_halo *h, struct dem_particles *p)
{
    const struct dem_halo_route *const from = &h->receive[h->sent];
    const size_t received = h->decomposition->ranks > 1 ? count_of(from, h->receive_ranks) : 0;

    dem_halo_wait(h);
    if (p->ghost_step.n == 0)
    {
        unpack(h, p, received, from->index, 0);
    }
    else
    {
        unpack(h, p, received, from->index, p->ghost_step.n);
    }
}

int dem_halo_refresh_window(struct dem_halo *h, struct dem_particles *p)
{
    const struct dem_column_list *const list = &p->ghost_window;
    const struct dem_halo_route *const to = &h->send[DEM_HALO_ALL];
    double *out = h->send_buffer;
    const double *in = h->receive_buffer;

    if (h->decomposition->ranks == 1)
    {
        return DEM_OK;
    }
    for (size_t k = 0; k < count_of(to, h->send_ranks); k++)
    {
        *out++ = p->record[to->index[k]].inverse_mass;
        for (int c = 0; c < list->n; c++)
        {
            *out++ = p->column[list->column[c]].data[to->index[k]];
        }
    }
    dem_halo_post(h, DEM_HALO_ALL, 1 + list->n);
    dem_halo_wait(h);
    for (size_t k = p->n; k < p->n + p->ghosts; k++)
    {
        p->record[k].inverse_mass = *in++;
        for (int c = 0; c < list->n; c++)
        {
            p->column[list->column[c]].data[k] = *in++;
        }
    }
    return DEM_OK;
}
