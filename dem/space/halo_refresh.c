/*
 * halo_refresh.c -- the routes on which copies are refreshed: of all, and of those that near rows touch.
 *
 * Copies are chosen by the outer skin, far more than a step needs. So when near rows have been pruned, each rank marks the copies
 * that they touch and sends the marks to the owners, a byte a copy: both sides know which copies there are and in which order. All
 * copies are refreshed before the next pruning only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/halo_refresh.h"
#include "base/memory.h"
#include "space/halo.h"
#include <string.h>

enum
{
    TAG_REFRESH = 72,
    TAG_MARKS = 73
};

static size_t count_of(const struct dem_route *r, int peers)
{
    return peers > 0 ? r->start[peers] : 0;
}

/* ---- choosing ------------------------------------------------------------------------------------------------ */

static int mark_wants(struct dem_halo *h, const struct dem_particles *p, const struct dem_contacts *c)
{
    DEM_TRY(DEM_GROW(h->wants, h->wants_room, p->ghosts + 1));
    DEM_TRY(DEM_GROW(h->wanted, h->wanted_room, count_of(&h->send[DEM_HALO_ALL], h->sends) + 1));
    memset(h->wants, 0, p->ghosts);
    for (uint32_t r = 0; r < c->rows; r++)
    {
        const struct dem_pair *const q = c->row_pair[r] == DEM_ROW_NONE ? NULL : &c->pair[c->row_pair[r]];

        if (q && !q->wall && q->i >= p->n)
        {
            h->wants[q->i - p->n] = 1;
        }
        if (q && !q->wall && q->j >= p->n)
        {
            h->wants[q->j - p->n] = 1;
        }
    }
    return DEM_OK;
}

static void exchange_marks(struct dem_halo *h)
{
    const size_t *const here = h->receive[DEM_HALO_ALL].start, *const there = h->send[DEM_HALO_ALL].start;

    for (int k = 0; k < h->sends; k++)
    {
        MPI_Irecv(h->wanted + there[k], (int)(there[k + 1] - there[k]), MPI_BYTE, h->send_peer[k], TAG_MARKS, h->pieces->comm,
                  &h->request[h->open++]);
    }
    for (int k = 0; k < h->receives; k++)
    {
        MPI_Isend(h->wants + here[k], (int)(here[k + 1] - here[k]), MPI_BYTE, h->receive_peer[k], TAG_MARKS, h->pieces->comm,
                  &h->request[h->open++]);
    }
    dem_halo_wait(h);
}

/* Those of a route that are marked. */
static int thin_out(struct dem_route *near, const struct dem_route *all, int peers, const uint8_t *mark)
{
    size_t kept = 0;

    DEM_TRY(DEM_GROW(near->start, near->start_room, peers + 2));
    DEM_TRY(DEM_GROW(near->index, near->room, count_of(all, peers) + 1));
    for (int k = 0; k < peers; k++)
    {
        near->start[k] = kept;
        for (size_t i = all->start[k]; i < all->start[k + 1]; i++)
        {
            near->index[kept] = all->index[i];
            kept += mark[i];
        }
        near->start[k + 1] = kept;
    }
    return DEM_OK;
}

int dem_halo_choose_near(struct dem_halo *h, const struct dem_particles *p, const struct dem_contacts *c)
{
    if (h->pieces->ranks == 1)
    {
        return DEM_OK;
    }
    DEM_TRY(mark_wants(h, p, c));
    exchange_marks(h);
    DEM_TRY(thin_out(&h->send[DEM_HALO_NEAR], &h->send[DEM_HALO_ALL], h->sends, h->wanted));
    return thin_out(&h->receive[DEM_HALO_NEAR], &h->receive[DEM_HALO_ALL], h->receives, h->wants);
}

/* ---- refreshing ---------------------------------------------------------------------------------------------- */

static void post(struct dem_halo *h, enum dem_halo_which which, int width)
{
    const struct dem_route *const to = &h->send[which], *const from = &h->receive[which];

    h->sent = which;
    for (int k = 0; k < h->receives; k++)
    {
        const int count = (int)(from->start[k + 1] - from->start[k])*width;

        if (count > 0)
        {
            MPI_Irecv(h->receive_buffer + from->start[k]*(size_t)width, count, MPI_DOUBLE, h->receive_peer[k], TAG_REFRESH,
                      h->pieces->comm, &h->request[h->open++]);
        }
    }
    for (int k = 0; k < h->sends; k++)
    {
        const int count = (int)(to->start[k + 1] - to->start[k])*width;

        if (count > 0)
        {
            MPI_Isend(h->send_buffer + to->start[k]*(size_t)width, count, MPI_DOUBLE, h->send_peer[k], TAG_REFRESH, h->pieces->comm,
                      &h->request[h->open++]);
            h->refreshed.messages++;
            h->refreshed.bytes += count*(int64_t)sizeof(double);
        }
    }
}

void dem_halo_wait(struct dem_halo *h)
{
    if (h->open > 0)
    {
        MPI_Waitall(h->open, h->request, MPI_STATUSES_IGNORE);
        h->open = 0;
    }
}

void dem_halo_send(struct dem_halo *h, const struct dem_particles *p, enum dem_halo_which which)
{
    const size_t sent = h->pieces->ranks > 1 ? count_of(&h->send[which], h->sends) : 0;

    for (size_t k = 0; k < sent; k++)
    {
        const struct dem_particle *const from = &p->record[h->send[which].index[k]];
        double *const to = h->send_buffer + DEM_HALO_WIDTH*k;

        memcpy(to, from->x, sizeof from->x);
        memcpy(to + 3, from->v, sizeof from->v);
        memcpy(to + 6, from->w, sizeof from->w);
    }
    if (h->pieces->ranks > 1)
    {
        post(h, which, DEM_HALO_WIDTH);
    }
}

void dem_halo_receive(struct dem_halo *h, struct dem_particles *p)
{
    const struct dem_route *const from = &h->receive[h->sent];
    const size_t received = h->pieces->ranks > 1 ? count_of(from, h->receives) : 0;

    dem_halo_wait(h);
    for (size_t k = 0; k < received; k++)
    {
        struct dem_particle *const to = &p->record[p->n + from->index[k]];
        const double *const got = h->receive_buffer + DEM_HALO_WIDTH*k;

        memcpy(to->x, got, sizeof to->x);
        memcpy(to->v, got + 3, sizeof to->v);
        memcpy(to->w, got + 6, sizeof to->w);
    }
}

int dem_halo_refresh_fluid(struct dem_halo *h, struct dem_particles *p)
{
    enum { WIDTH = 2 };
    const struct dem_route *const to = &h->send[DEM_HALO_ALL];

    if (h->pieces->ranks == 1)
    {
        return DEM_OK;
    }
    for (size_t k = 0; k < count_of(to, h->sends); k++)
    {
        h->send_buffer[WIDTH*k] = p->record[to->index[k]].viscosity;
        h->send_buffer[WIDTH*k + 1] = p->record[to->index[k]].inverse_mass;
    }
    post(h, DEM_HALO_ALL, WIDTH);
    dem_halo_wait(h);
    for (size_t k = 0; k < p->ghosts; k++)
    {
        p->record[p->n + k].viscosity = h->receive_buffer[WIDTH*k];
        p->record[p->n + k].inverse_mass = h->receive_buffer[WIDTH*k + 1];
    }
    return DEM_OK;
}
