/*
 * halo_migrate.c -- migration: particles that have left the subdomain of their rank are sent to
 * their new owner with columns and contact history.
 *
 * One message per destination: number of particles, number of saved contacts, particles, contacts.
 * The history of a contact is sent with its lower and with its higher particle, so that both owners
 * have it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "ranks/halo.h"
#include "core/memory.h"
#include "core/sort.h"
#include "particles/clump.h"
#include <string.h>

enum
{
    KEY = (int)(sizeof(struct dem_contact_key)/sizeof(double)) /* doubles of a key */
};
_Static_assert(sizeof(struct dem_contact_key)%sizeof(double) == 0,
               "the key of a saved contact is sent as doubles");

/* ---- destinations ---------------------------------------------------------------------------- */

struct id_slot                                              /* slot of a hash table */
{
    int64_t id;
    uint32_t particle;            /* index + 1; 0: free slot */
};

/* Hash table (open addressing) from id to owned particle, to find the particles of a saved
   contact. */
static int index_ids(const struct dem_particles *p, struct id_slot **table, size_t *mask)
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
        (*table)[slot] = (struct id_slot){p->record[i].id, (uint32_t)i + 1};
    }
    return DEM_OK;
}

/* The owned particle with this id, or n. */
static size_t find_id(const struct dem_particles *p, const struct id_slot *table, size_t mask,
                      int64_t id)
{
    size_t slot = (uint64_t)id*0x9e3779b97f4a7c15u >> 20 & mask;

    while (table[slot].particle && table[slot].id != id)
    {
        slot = (slot + 1) & mask;
    }
    return table[slot].particle ? table[slot].particle - 1 : p->n;
}

/* Destination rank of each particle (-1: stays), and of each saved contact with its lower and with
   its higher particle. */
static int destinations(struct dem_halo *h, const struct dem_particles *p,
                        const struct dem_contacts *c, int *owner, int *row_owner, int *leaving)
{
    const int me = h->decomposition->rank;
    struct id_slot *table;
    size_t mask;

    *leaving = 0;
    for (size_t i = 0; i < p->n; i++)
    {
        const int to = dem_decomposition_owner(h->decomposition, dem_clump_home(p, i));

        owner[i] = to == me ? -1 : to;
        *leaving += to != me;
    }
    DEM_TRY(index_ids(p, &table, &mask));
    for (size_t r = 0; r < 2*c->history.saved; r++)
    {
        const int64_t id = r%2 ? c->history.saved_key[r/2].high : c->history.saved_key[r/2].low;
        const size_t i = id < 0 ? p->n : find_id(p, table, mask, id);

        row_owner[r] = i < p->n ? owner[i] : -1;
        /* both particles go to the same rank: send the contact once */
        row_owner[r] = r%2 && row_owner[r] == row_owner[r - 1] ? -1 : row_owner[r];
    }
    dem_memory_free(table);
    return DEM_OK;
}

/* ---- messages -------------------------------------------------------------------------------- */

struct outgoing                                            /* what leaves, sorted by destination */
{
    size_t n;
    uint64_t *to;                 /* destination rank */
    uint32_t *which;              /* particle; or 2 contact + (0 lower, 1 higher particle) */
};

static void free_outgoing(struct outgoing *l)
{
    dem_memory_free(l->to);
    dem_memory_free(l->which);
}

static int sort_outgoing(struct outgoing *l, const int *owner, size_t n)
{
    uint64_t *keys = NULL;
    uint32_t *scratch = NULL;

    l->n = 0;
    for (size_t i = 0; i < n; i++)
    {
        l->n += owner[i] >= 0;
    }
    int status = DEM_NEW(l->to, l->n + 1);

    status = status ? status : DEM_NEW(l->which, l->n + 1);
    status = status ? status : DEM_NEW(keys, l->n + 1);
    status = status ? status : DEM_NEW(scratch, l->n + 1);
    for (size_t i = 0, k = 0; i < n && !status; i++)
    {
        if (owner[i] >= 0)
        {
            l->to[k] = (uint64_t)owner[i];
            l->which[k++] = (uint32_t)i;
        }
    }
    if (!status)
    {
        dem_sort_keys(l->to, l->which, l->n, keys, scratch);
    }
    dem_memory_free(keys);
    dem_memory_free(scratch);
    return status;
}

/* Number of consecutive items from index `first` with destination `to`. */
static size_t run_of(const struct outgoing *l, size_t first, uint64_t to)
{
    size_t n = 0;

    while (first + n < l->n && l->to[first + n] == to)
    {
        n++;
    }
    return n;
}

/* Write all messages. A contact is sent only to ranks that also get a particle. */
static int write_messages(struct dem_halo *h, const struct dem_particles *p,
                          const struct dem_contacts *c, const struct outgoing *particles_out,
                          const struct outgoing *contacts_out)
{
    const size_t size = dem_particles_packed_size(p), memories = (size_t)c->history.columns;
    double *data;

    for (size_t i = 0, r = 0; i < particles_out->n;)
    {
        const uint64_t to_rank = particles_out->to[i];
        const size_t particles = i + run_of(particles_out, i, to_rank),
                     rows = r + run_of(contacts_out, r, to_rank);

        DEM_TRY(dem_messages_begin(&h->out, (int)to_rank));
        DEM_TRY(dem_messages_extend(&h->out,
                                    2 + (particles - i)*size + (rows - r)*(KEY + memories),
                                    &data));
        *data++ = (double)(particles - i);
        *data++ = (double)(rows - r);
        for (; i < particles; i++, data += size)
        {
            dem_particles_pack(p, particles_out->which[i], data);
        }
        for (; r < rows; r++, data += KEY + memories)
        {
            const size_t row = contacts_out->which[r]/2;

            memcpy(data, &c->history.saved_key[row], sizeof *c->history.saved_key);
            memcpy(data + KEY, c->history.saved_value + row*memories, memories*sizeof *data);
        }
    }
    return DEM_OK;
}

static int pack_outgoing(struct dem_halo *h, const struct dem_particles *p,
                         const struct dem_contacts *c, const int *owner, const int *row_owner)
{
    struct outgoing particles_out = {.n = 0}, contacts_out = {.n = 0};

    dem_messages_clear(&h->out);
    int status = sort_outgoing(&particles_out, owner, p->n);

    status = status ? status : sort_outgoing(&contacts_out, row_owner, 2*c->history.saved);
    status = status ? status : write_messages(h, p, c, &particles_out, &contacts_out);
    free_outgoing(&particles_out);
    free_outgoing(&contacts_out);
    return status;
}

static int read_messages(struct dem_halo *h, struct dem_particles *p, struct dem_contacts *c)
{
    const size_t size = dem_particles_packed_size(p), memories = (size_t)c->history.columns;

    for (int k = 0; k < h->in.ranks; k++)
    {
        const double *data = h->in.data + h->in.start[k];
        const size_t particles = (size_t)data[0], rows = (size_t)data[1];

        data += 2;
        for (size_t i = 0; i < particles; i++, data += size)
        {
            DEM_TRY(dem_particles_append(p, data));
        }
        for (size_t r = 0; r < rows; r++, data += KEY + memories)
        {
            struct dem_contact_key key;

            memcpy(&key, data, sizeof key);
            DEM_TRY(dem_contact_history_append(&c->history, &key, data + KEY));
        }
    }
    return DEM_OK;
}

static int remove_outgoing(struct dem_particles *p, const int *owner)
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

/* Write the messages and remove the particles in them. */
static int take_outgoing(struct dem_halo *h, struct dem_particles *p, const struct dem_contacts *c)
{
    int *owner = NULL, *row_owner = NULL, leaving = 0;
    int status = DEM_NEW(owner, p->n + 1);

    status = status ? status : DEM_NEW(row_owner, 2*c->history.saved + 1);
    status = status ? status : destinations(h, p, c, owner, row_owner, &leaving);
    status = status ? status : pack_outgoing(h, p, c, owner, row_owner);
    status = status || !leaving ? status : remove_outgoing(p, owner);
    dem_memory_free(owner);
    dem_memory_free(row_owner);
    return status;
}

int dem_halo_migrate(struct dem_halo *h, int status, struct dem_particles *p,
                     struct dem_contacts *c)
{
    p->ghosts = 0;
    if (h->decomposition->ranks == 1)
    {
        return status;
    }
    status = status ? status : take_outgoing(h, p, c);
    DEM_TRY(dem_messages_exchange(h->decomposition->comm, status, &h->out, &h->in));
    return read_messages(h, p, c);
}
