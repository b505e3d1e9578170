/*
 * halo.c -- letters with particles and rows in them, and the fixed routes of the refresh.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/halo.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

enum
{
    REFRESHED = 9,                                        /* x, v, w */
    RECORD = (int)(sizeof(struct dem_particle)/sizeof(double)),
    NAME = (int)(sizeof(struct dem_carried)/sizeof(double)),
    TAG_REFRESH = 72
};
_Static_assert(sizeof(struct dem_carried)%sizeof(double) == 0, "a carried row's name travels as doubles");

void dem_halo_init(struct dem_halo *h, struct dem_pieces *pieces)
{
    memset(h, 0, sizeof *h);
    h->pieces = pieces;
}

void dem_halo_free(struct dem_halo *h)
{
    dem_mail_free(&h->out);
    dem_mail_free(&h->in);
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

/* ---- migration ----------------------------------------------------------------------------------------------- */


struct named
{
    int64_t id;
    uint32_t particle;
};

/* Open addressing from id to owned particle, for finding whose a carried row is. */
static int index_ids(const struct dem_particles *p, struct named **table, size_t *mask)
{
    *mask = 15;
    while (*mask < 2*p->n)
    {
        *mask = 2**mask + 1;
    }
    DEM_TRY(DEM_NEW(*table, *mask + 1));
    for (size_t i = 0; i < p->n; i++)
    {
        size_t slot = (uint64_t)p->record[i].id*0x9e3779b97f4a7c15u >> 20 & *mask;

        while ((*table)[slot].particle)
        {
            slot = (slot + 1) & *mask;
        }
        (*table)[slot] = (struct named){p->record[i].id, (uint32_t)i + 1};
    }
    return DEM_OK;
}

/* The owned particle with this id, or n. */
static size_t find_id(const struct dem_particles *p, const struct named *table, size_t mask, int64_t id)
{
    size_t slot = (uint64_t)id*0x9e3779b97f4a7c15u >> 20 & mask;

    while (table[slot].particle && table[slot].id != id)
    {
        slot = (slot + 1) & mask;
    }
    return table[slot].particle ? table[slot].particle - 1 : p->n;
}

/* One letter a destination: number of particles, of rows, particles, rows. */
static int write_letter(struct dem_halo *h, const struct dem_particles *p, const struct dem_contacts *c, int peer,
                        const int *owner, const int *row_owner)
{
    const size_t size = dem_particles_packed_size(p), memories = (size_t)c->memories;
    size_t particles = 0, rows = 0;
    double *where;

    for (size_t i = 0; i < p->n; i++)
    {
        particles += owner[i] == peer;
    }
    for (size_t r = 0; r < 2*c->carried; r++)
    {
        rows += row_owner[r] == peer;
    }
    DEM_TRY(dem_mail_letter(&h->out, peer));
    DEM_TRY(dem_mail_room(&h->out, 2 + particles*size + rows*(NAME + memories), &where));
    *where++ = (double)particles;
    *where++ = (double)rows;
    for (size_t i = 0; i < p->n; i++)
    {
        if (owner[i] == peer)
        {
            dem_particles_pack(p, i, where);
            where += size;
        }
    }
    for (size_t r = 0; r < 2*c->carried; r++)
    {
        if (row_owner[r] == peer)
        {
            memcpy(where, &c->carry[r/2], sizeof *c->carry);
            memcpy(where + NAME, c->kept + r/2*memories, memories*sizeof *where);
            where += NAME + memories;
        }
    }
    return DEM_OK;
}

static int read_letters(struct dem_halo *h, struct dem_particles *p, struct dem_contacts *c)
{
    const size_t size = dem_particles_packed_size(p), memories = (size_t)c->memories;

    for (int k = 0; k < h->in.peers; k++)
    {
        const double *where = h->in.data + h->in.start[k];
        const size_t particles = (size_t)where[0], rows = (size_t)where[1];

        where += 2;
        for (size_t i = 0; i < particles; i++, where += size)
        {
            DEM_TRY(dem_particles_append(p, where));
        }
        for (size_t r = 0; r < rows; r++, where += NAME + memories)
        {
            struct dem_carried name;

            memcpy(&name, where, sizeof name);
            DEM_TRY(dem_contacts_carry(c, &name, where + NAME));
        }
    }
    return DEM_OK;
}

/* Where each particle goes (-1: stays), and where each carried row goes with its lower and its higher particle. */
static int destinations(struct dem_halo *h, const struct dem_particles *p, const struct dem_contacts *c, int *owner,
                        int *row_owner, int *leaving)
{
    const int me = h->pieces->rank;
    struct named *table;
    size_t mask;

    *leaving = 0;
    for (size_t i = 0; i < p->n; i++)
    {
        const int to = dem_pieces_owner(h->pieces, p->record[i].x);

        owner[i] = to == me ? -1 : to;
        *leaving += to != me;
    }
    DEM_TRY(index_ids(p, &table, &mask));
    for (size_t r = 0; r < 2*c->carried; r++)
    {
        const int64_t id = r%2 ? c->carry[r/2].high : c->carry[r/2].low;
        const size_t i = id < 0 ? p->n : find_id(p, table, mask, id);

        row_owner[r] = i < p->n ? owner[i] : -1;
        /* both partners to the same place: once is enough */
        row_owner[r] = r%2 && row_owner[r] == row_owner[r - 1] ? -1 : row_owner[r];
    }
    dem_memory_free(table);
    return DEM_OK;
}

static int drop_leavers(struct dem_particles *p, const int *owner)
{
    uint32_t *order;
    size_t kept = 0;

    DEM_TRY(DEM_NEW(order, p->n + 1));
    for (size_t i = 0; i < p->n; i++)
    {
        if (owner[i] < 0)
        {
            order[kept++] = (uint32_t)i;
        }
    }
    dem_particles_reorder(p, order, kept);
    dem_memory_free(order);
    return DEM_OK;
}

int dem_halo_migrate(struct dem_halo *h, struct dem_particles *p, struct dem_contacts *c)
{
    int *owner, *row_owner, leaving;
    char *wanted;

    p->ghosts = 0;
    if (h->pieces->ranks == 1)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(owner, p->n + 1));
    DEM_TRY(DEM_NEW(row_owner, 2*c->carried + 1));
    DEM_TRY(DEM_NEW(wanted, h->pieces->ranks + 1));
    DEM_TRY(destinations(h, p, c, owner, row_owner, &leaving));
    dem_mail_clear(&h->out);
    for (size_t i = 0; i < p->n; i++)
    {
        if (owner[i] >= 0)
        {
            wanted[owner[i]] = 1;
        }
    }
    for (int peer = 0; peer < h->pieces->ranks; peer++)
    {
        if (wanted[peer])
        {
            DEM_TRY(write_letter(h, p, c, peer, owner, row_owner));
        }
    }
    if (leaving)
    {
        DEM_TRY(drop_leavers(p, owner));
    }
    dem_memory_free(owner);
    dem_memory_free(row_owner);
    dem_memory_free(wanted);
    DEM_TRY(dem_mail_exchange(h->pieces->comm, &h->out, &h->in));
    return read_letters(h, p, c);
}

/* ---- copies -------------------------------------------------------------------------------------------------- */

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

/* 1 when two boxes come within `reach` along every axis, images included. */
static int boxes_in_reach(const struct dem_domain *d, double a[2][3], double b[2][3], double reach)
{
    int near = 1;

    for (int k = 0; k < 3; k++)
    {
        int axis = 0;

        for (int s = -d->periodic[k]; s <= d->periodic[k]; s++)
        {
            axis |= a[0][k] + s*d->length[k] < b[1][k] + reach && a[1][k] + s*d->length[k] > b[0][k] - reach;
        }
        near &= axis;
    }
    return near;
}

static int choose_copies(struct dem_halo *h, const struct dem_particles *p, const struct dem_domain *d, double most_radius,
                         double reach)
{
    double mine[2][3], box[2][3], *where;
    size_t count = 0;

    h->sends = 0;
    dem_mail_clear(&h->out);
    dem_pieces_box(h->pieces, h->pieces->rank, mine[0], mine[1]);
    for (int peer = 0; peer < h->pieces->ranks; peer++)
    {
        const size_t first = count;

        dem_pieces_box(h->pieces, peer, box[0], box[1]);
        if (peer == h->pieces->rank || !boxes_in_reach(d, mine, box, 2.0*most_radius + reach))
        {
            continue;
        }
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
            for (size_t k = first; k < count; k++, where += RECORD)
            {
                memcpy(where, &p->record[h->send_index[k]], sizeof *p->record);
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

static void send_and_receive(struct dem_halo *h, int width)
{
    int open = 0;

    for (int k = 0; k < h->receives; k++)
    {
        MPI_Irecv(h->receive_buffer + h->receive_start[k]*(size_t)width,
                  (int)(h->receive_start[k + 1] - h->receive_start[k])*width, MPI_DOUBLE, h->receive_peer[k], TAG_REFRESH,
                  h->pieces->comm, &h->request[open++]);
    }
    for (int k = 0; k < h->sends; k++)
    {
        MPI_Isend(h->send_buffer + h->send_start[k]*(size_t)width, (int)(h->send_start[k + 1] - h->send_start[k])*width,
                  MPI_DOUBLE, h->send_peer[k], TAG_REFRESH, h->pieces->comm, &h->request[open++]);
    }
    MPI_Waitall(open, h->request, MPI_STATUSES_IGNORE);
}

int dem_halo_refresh(struct dem_halo *h, struct dem_particles *p)
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
        send_and_receive(h, REFRESHED);
    }
    for (size_t k = 0; k < p->ghosts; k++)
    {
        struct dem_particle *const to = &p->record[p->n + k];
        const double *const from = h->receive_buffer + REFRESHED*k;

        memcpy(to->x, from, sizeof to->x);
        memcpy(to->v, from + 3, sizeof to->v);
        memcpy(to->w, from + 6, sizeof to->w);
    }
    return DEM_OK;
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
        send_and_receive(h, 1);
    }
    for (size_t k = 0; k < p->ghosts; k++)
    {
        p->record[p->n + k].viscosity = h->receive_buffer[k];
    }
    return DEM_OK;
}
