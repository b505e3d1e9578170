/*
 * halo_migrate.c -- particles that now live in another rank's piece go there, with their columns and their contact memory.
 *
 * One letter a destination: number of particles, number of carried rows, particles, rows. A row follows its lower and its
 * higher particle, so both owners know what the contact remembers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/halo.h"
#include "base/memory.h"
#include "base/sort.h"
#include <string.h>

enum
{
    NAME = (int)(sizeof(struct dem_carried)/sizeof(double))
};
_Static_assert(sizeof(struct dem_carried)%sizeof(double) == 0, "a carried row's name travels as doubles");

/* ---- who goes where ------------------------------------------------------------------------------------------ */

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

/* ---- letters ------------------------------------------------------------------------------------------------- */

struct leavers                                            /* sorted by where they go */
{
    size_t n;
    uint64_t *to;
    uint32_t *which;
};

static void free_leavers(struct leavers *l)
{
    dem_memory_free(l->to);
    dem_memory_free(l->which);
}

static int sort_leavers(struct leavers *l, const int *owner, size_t n)
{
    uint64_t *keys;
    uint32_t *places;

    l->n = 0;
    for (size_t i = 0; i < n; i++)
    {
        l->n += owner[i] >= 0;
    }
    DEM_TRY(DEM_NEW(l->to, l->n + 1));
    DEM_TRY(DEM_NEW(l->which, l->n + 1));
    DEM_TRY(DEM_NEW(keys, l->n + 1));
    DEM_TRY(DEM_NEW(places, l->n + 1));
    for (size_t i = 0, k = 0; i < n; i++)
    {
        if (owner[i] >= 0)
        {
            l->to[k] = (uint64_t)owner[i];
            l->which[k++] = (uint32_t)i;
        }
    }
    dem_sort_keys(l->to, l->which, l->n, keys, places);
    dem_memory_free(keys);
    dem_memory_free(places);
    return DEM_OK;
}

/* How many from place `first` on go where that one goes. */
static size_t run_of(const struct leavers *l, size_t first, uint64_t to)
{
    size_t n = 0;

    while (first + n < l->n && l->to[first + n] == to)
    {
        n++;
    }
    return n;
}

/* All letters; a row goes only where a particle goes. */
static int write_letters(struct dem_halo *h, const struct dem_particles *p, const struct dem_contacts *c, const struct leavers *who,
                         const struct leavers *what)
{
    const size_t size = dem_particles_packed_size(p), memories = (size_t)c->memories;
    double *where;

    for (size_t i = 0, r = 0; i < who->n;)
    {
        const uint64_t peer = who->to[i];
        const size_t particles = i + run_of(who, i, peer), rows = r + run_of(what, r, peer);

        DEM_TRY(dem_mail_letter(&h->out, (int)peer));
        DEM_TRY(dem_mail_room(&h->out, 2 + (particles - i)*size + (rows - r)*(NAME + memories), &where));
        *where++ = (double)(particles - i);
        *where++ = (double)(rows - r);
        for (; i < particles; i++, where += size)
        {
            dem_particles_pack(p, who->which[i], where);
        }
        for (; r < rows; r++, where += NAME + memories)
        {
            const size_t row = what->which[r]/2;

            memcpy(where, &c->carry[row], sizeof *c->carry);
            memcpy(where + NAME, c->kept + row*memories, memories*sizeof *where);
        }
    }
    return DEM_OK;
}

static int post_leavers(struct dem_halo *h, const struct dem_particles *p, const struct dem_contacts *c, const int *owner,
                        const int *row_owner)
{
    struct leavers who = {.n = 0}, what = {.n = 0};

    dem_mail_clear(&h->out);
    DEM_TRY(sort_leavers(&who, owner, p->n));
    DEM_TRY(sort_leavers(&what, row_owner, 2*c->carried));
    DEM_TRY(write_letters(h, p, c, &who, &what));
    free_leavers(&who);
    free_leavers(&what);
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

    p->ghosts = 0;
    if (h->pieces->ranks == 1)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(owner, p->n + 1));
    DEM_TRY(DEM_NEW(row_owner, 2*c->carried + 1));
    DEM_TRY(destinations(h, p, c, owner, row_owner, &leaving));
    DEM_TRY(post_leavers(h, p, c, owner, row_owner));
    if (leaving)
    {
        DEM_TRY(drop_leavers(p, owner));
    }
    dem_memory_free(owner);
    dem_memory_free(row_owner);
    DEM_TRY(dem_mail_exchange(h->pieces->comm, &h->out, &h->in));
    return read_letters(h, p, c);
}
