/*
 * halo.c -- copies: who needs which, and the fixed routes on which they are refreshed. Migration is in halo_migrate.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/halo_peers.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

enum
{
    REFRESHED = 9,                                        /* x, v, w */
    RECORD = (int)(sizeof(struct dem_particle)/sizeof(double)),
    TAG_REFRESH = 72
};

void dem_halo_init(struct dem_halo *h, struct dem_pieces *pieces)
{
    memset(h, 0, sizeof *h);
    h->pieces = pieces;
}

void dem_halo_free(struct dem_halo *h)
{
    dem_mail_free(&h->out);
    dem_mail_free(&h->in);
    dem_memory_free(h->peer);
    dem_memory_free(h->send_peer);
    dem_memory_free(h->receive_peer);
    dem_memory_free(h->send_start);
    dem_memory_free(h->receive_start);
    dem_memory_free(h->send_index);
    dem_memory_free(h->send_buffer);
    dem_memory_free(h->receive_buffer);
    dem_memory_free(h->request);
    memset(h, 0, sizeof *h);
}

/* ---- choosing ------------------------------------------------------------------------------------------------ */

/* 1 when some periodic image of x lies within `reach` of the box. */
static int box_in_reach(const struct dem_domain *d, const double x[3], const double min[3], const double max[3], double reach)
{
    double square = 0.0;

    for (int k = 0; k < 3; k++)
    {
        double nearest = INFINITY;

        for (int s = -d->periodic[k]; s <= d->periodic[k]; s++)
        {
            const double y = x[k] + s*d->length[k], gap = fmax(0.0, fmax(min[k] - y, y - max[k]));

            nearest = fmin(nearest, gap);
        }
        square += nearest*nearest;
    }
    return square < reach*reach;
}

static int choose_copies(struct dem_halo *h, const struct dem_particles *p, const struct dem_domain *d, double most_radius,
                         double reach)
{
    double box[2][3], *where;
    size_t count = 0;

    h->sends = 0;
    dem_mail_clear(&h->out);
    DEM_TRY(dem_halo_find_peers(h, d, 2.0*most_radius + reach));
    for (int k = 0; k < h->peers; k++)
    {
        const int peer = h->peer[k];
        const size_t first = count;

        dem_halo_box(h, d, peer, box);
        for (size_t i = 0; i < p->n; i++)
        {
            if (box_in_reach(d, p->record[i].x, box[0], box[1], p->record[i].radius + most_radius + reach))
            {
                DEM_TRY(DEM_GROW(h->send_index, h->send_index_room, count + 1));
                h->send_index[count++] = (uint32_t)i;
            }
        }
        if (count > first)
        {
            DEM_TRY(DEM_GROW(h->send_peer, h->send_peer_room, h->sends + 1));
            DEM_TRY(DEM_GROW(h->send_start, h->send_start_room, h->sends + 2));
            h->send_peer[h->sends] = peer;
            h->send_start[h->sends] = first;
            h->send_start[++h->sends] = count;
            DEM_TRY(dem_mail_letter(&h->out, peer));
            DEM_TRY(dem_mail_room(&h->out, (count - first)*RECORD, &where));
            for (size_t i = first; i < count; i++, where += RECORD)
            {
                memcpy(where, &p->record[h->send_index[i]], sizeof *p->record);
            }
        }
    }
    return DEM_GROW(h->send_buffer, h->send_room, count*REFRESHED + 1);
}

static int take_copies(struct dem_halo *h, struct dem_particles *p)
{
    p->ghosts = 0;
    h->receives = h->in.peers;
    DEM_TRY(DEM_GROW(h->receive_peer, h->receive_peer_room, h->receives + 1));
    DEM_TRY(DEM_GROW(h->receive_start, h->receive_start_room, h->receives + 2));
    for (int k = 0; k < h->in.peers; k++)
    {
        const size_t count = (h->in.start[k + 1] - h->in.start[k])/RECORD;

        DEM_TRY(dem_particles_grow(p, p->n + p->ghosts + count));
        memcpy(&p->record[p->n + p->ghosts], h->in.data + h->in.start[k], count*sizeof *p->record);
        h->receive_peer[k] = h->in.peer[k];
        h->receive_start[k] = p->ghosts;
        p->ghosts += count;
        h->receive_start[k + 1] = p->ghosts;
    }
    DEM_TRY(DEM_GROW(h->request, h->request_room, h->sends + h->receives + 1));
    return DEM_GROW(h->receive_buffer, h->receive_room, p->ghosts*REFRESHED + 1);
}

int dem_halo_renew(struct dem_halo *h, struct dem_particles *p, const struct dem_domain *d, double most_radius, double reach)
{
    p->ghosts = 0;
    if (h->pieces->ranks == 1)
    {
        return DEM_OK;
    }
    DEM_TRY(choose_copies(h, p, d, most_radius, reach));
    DEM_TRY(dem_mail_exchange(h->pieces->comm, &h->out, &h->in));
    return take_copies(h, p);
}

/* ---- refreshing ---------------------------------------------------------------------------------------------- */

static void post(struct dem_halo *h, int width)
{
    h->open = 0;
    for (int k = 0; k < h->receives; k++)
    {
        MPI_Irecv(h->receive_buffer + h->receive_start[k]*(size_t)width,
                  (int)(h->receive_start[k + 1] - h->receive_start[k])*width, MPI_DOUBLE, h->receive_peer[k], TAG_REFRESH,
                  h->pieces->comm, &h->request[h->open++]);
    }
    for (int k = 0; k < h->sends; k++)
    {
        MPI_Isend(h->send_buffer + h->send_start[k]*(size_t)width, (int)(h->send_start[k + 1] - h->send_start[k])*width,
                  MPI_DOUBLE, h->send_peer[k], TAG_REFRESH, h->pieces->comm, &h->request[h->open++]);
    }
    h->refreshed.messages += h->sends;
    h->refreshed.bytes += h->sends > 0 ? (int64_t)(h->send_start[h->sends]*(size_t)width*sizeof *h->send_buffer) : 0;
}

void dem_halo_wait(struct dem_halo *h)
{
    if (h->open > 0)
    {
        MPI_Waitall(h->open, h->request, MPI_STATUSES_IGNORE);
        h->open = 0;
    }
}

void dem_halo_send(struct dem_halo *h, const struct dem_particles *p)
{
    const size_t sent = h->pieces->ranks > 1 && h->sends ? h->send_start[h->sends] : 0;

    for (size_t k = 0; k < sent; k++)
    {
        const struct dem_particle *const from = &p->record[h->send_index[k]];
        double *const to = h->send_buffer + REFRESHED*k;

        memcpy(to, from->x, sizeof from->x);
        memcpy(to + 3, from->v, sizeof from->v);
        memcpy(to + 6, from->w, sizeof from->w);
    }
    if (h->pieces->ranks > 1)
    {
        post(h, REFRESHED);
    }
}

void dem_halo_receive(struct dem_halo *h, struct dem_particles *p)
{
    dem_halo_wait(h);
    for (size_t k = 0; k < p->ghosts; k++)
    {
        struct dem_particle *const to = &p->record[p->n + k];
        const double *const from = h->receive_buffer + REFRESHED*k;

        memcpy(to->x, from, sizeof to->x);
        memcpy(to->v, from + 3, sizeof to->v);
        memcpy(to->w, from + 6, sizeof to->w);
    }
}

int dem_halo_refresh_viscosity(struct dem_halo *h, struct dem_particles *p)
{
    const size_t sent = h->pieces->ranks > 1 && h->sends ? h->send_start[h->sends] : 0;

    for (size_t k = 0; k < sent; k++)
    {
        h->send_buffer[k] = p->record[h->send_index[k]].viscosity;
    }
    if (h->pieces->ranks > 1)
    {
        post(h, 1);
        dem_halo_wait(h);
    }
    for (size_t k = 0; k < p->ghosts; k++)
    {
        p->record[p->n + k].viscosity = h->receive_buffer[k];
    }
    return DEM_OK;
}
