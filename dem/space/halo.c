/*
 * halo.c -- copies: who needs which. How they are refreshed is in halo_refresh.c, migration in halo_migrate.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/halo_peers.h"
#include "space/halo_refresh.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

enum
{
    RECORD = (int)(sizeof(struct dem_particle)/sizeof(double))
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
    for (int k = 0; k < DEM_HALO_ROUTES; k++)
    {
        dem_memory_free(h->send[k].start);
        dem_memory_free(h->send[k].index);
        dem_memory_free(h->receive[k].start);
        dem_memory_free(h->receive[k].index);
    }
    dem_memory_free(h->peer);
    dem_memory_free(h->send_peer);
    dem_memory_free(h->receive_peer);
    dem_memory_free(h->wants);
    dem_memory_free(h->wanted);
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
    struct dem_route *const all = &h->send[DEM_HALO_ALL];
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
                DEM_TRY(DEM_GROW(all->index, all->room, count + 1));
                all->index[count++] = (uint32_t)i;
            }
        }
        if (count > first)
        {
            DEM_TRY(DEM_GROW(h->send_peer, h->send_peer_room, h->sends + 1));
            DEM_TRY(DEM_GROW(all->start, all->start_room, h->sends + 2));
            h->send_peer[h->sends] = peer;
            all->start[h->sends] = first;
            all->start[++h->sends] = count;
            DEM_TRY(dem_mail_letter(&h->out, peer));
            DEM_TRY(dem_mail_room(&h->out, (count - first)*RECORD, &where));
            for (size_t i = first; i < count; i++, where += RECORD)
            {
                memcpy(where, &p->record[all->index[i]], sizeof *p->record);
            }
        }
    }
    return DEM_GROW(h->send_buffer, h->send_room, count*DEM_HALO_WIDTH + 1);
}

static int take_copies(struct dem_halo *h, struct dem_particles *p)
{
    struct dem_route *const all = &h->receive[DEM_HALO_ALL];

    p->ghosts = 0;
    h->receives = h->in.peers;
    DEM_TRY(DEM_GROW(h->receive_peer, h->receive_peer_room, h->receives + 1));
    DEM_TRY(DEM_GROW(all->start, all->start_room, h->receives + 2));
    for (int k = 0; k < h->in.peers; k++)
    {
        const size_t count = (h->in.start[k + 1] - h->in.start[k])/RECORD;

        DEM_TRY(dem_particles_grow(p, p->n + p->ghosts + count));
        memcpy(&p->record[p->n + p->ghosts], h->in.data + h->in.start[k], count*sizeof *p->record);
        h->receive_peer[k] = h->in.peer[k];
        all->start[k] = p->ghosts;
        p->ghosts += count;
        all->start[k + 1] = p->ghosts;
    }
    DEM_TRY(DEM_GROW(all->index, all->room, p->ghosts + 1));
    for (size_t k = 0; k < p->ghosts; k++)
    {
        all->index[k] = (uint32_t)k;
    }
    DEM_TRY(DEM_GROW(h->request, h->request_room, h->sends + h->receives + 1));
    return DEM_GROW(h->receive_buffer, h->receive_room, p->ghosts*DEM_HALO_WIDTH + 1);
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
