/*
 * snapshot_write.c -- pack particles and contacts block by block and write them with all ranks.
 *
 * Each rank writes its particles and the contacts it counts behind the lower ranks; the
 * first rank writes the data of the caller and, last, the header.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/snapshot.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/hash.h"
#include "records/snapshot_header.h"
#include "ranks/collect.h"
#include <string.h>

enum
{
    BLOCK = 1 << 24                                       /* bytes packed before they are written */
};

/* ---- header ---------------------------------------------------------------------------------- */

static void list_name(struct dem_snapshot_header *h, int64_t at, const char *name, int width)
{
    strncpy(h->list[at].name, name, DEM_SNAPSHOT_NAME - 1);
    h->list[at].width = width;
}

static void describe(struct dem_snapshot_header *h, const struct dem_snapshot *s,
                     const struct dem_interaction_table *r, const struct dem_particles *p)
{
    memcpy(h->magic, dem_snapshot_magic, sizeof dem_snapshot_magic);
    h->order = dem_snapshot_order;
    h->version = DEM_SNAPSHOT_VERSION;
    h->steps = s->steps;
    h->time = s->time;
    h->window = s->window;
    memcpy(h->skin_tuning, s->skin_tuning, sizeof h->skin_tuning);
    h->flows = s->flows;
    h->next_id = s->next_id;
    memcpy(h->flow, s->flow, (size_t)s->flows*sizeof *h->flow);
    for (int k = 0; k < r->materials; k++)
    {
        list_name(h, h->materials++, r->material[k].name, 0);
    }
    for (int c = 0; c < p->columns; c++)
    {
        if (p->column[c].data)
        {
            list_name(h, h->materials + h->columns++, p->column[c].name, p->column[c].width);
        }
    }
    for (int m = 0; m < r->history_columns; m++)
    {
        list_name(h, h->materials + h->columns + h->memories++, r->history_name[m], 1);
    }
}

/* ---- items ----------------------------------------------------------------------------------- */

struct items                /* what one rank writes: particles or contacts */
{
    size_t n, size;         /* number of items, doubles of one */
    void (*pack)(const struct items *, size_t k, double *out);
    const struct dem_particles *particles;
    const struct dem_domain *domain;
    const struct dem_contacts *contacts;
    const struct dem_facet_key *wall_facet;
    const uint32_t *row;    /* near rows; from contacts->rows on: saved history */
};

/* The record comes first. The written position must not depend on when the particle was last
   wrapped into the periodic box. */
static void pack_particle(const struct items *g, size_t k, double *out)
{
    struct dem_particle wrapped = g->particles->record[k];

    dem_particles_pack(g->particles, k, out);
    dem_domain_wrap(g->domain, &wrapped);
    memcpy(out, &wrapped, sizeof wrapped);
}

static void pack_contact(const struct items *g, size_t k, double *out)
{
    const struct dem_contacts *const c = g->contacts;
    const int near = g->row[k] < c->rows.n;
    const size_t saved = near ? 0 : g->row[k] - c->rows.n;
    const struct dem_contact_key name =
        near ? dem_contacts_key(c, g->particles, g->wall_facet, g->row[k])
             : c->history.saved_key[saved];
    struct dem_contact_key written;

    memset(&written, 0, sizeof written);
    written.low = name.low;
    written.high = name.high;
    written.image = name.image;
    memcpy(out, &written, sizeof written);
    if (near)
    {
        dem_contact_history_get(&c->history, g->row[k], out + DEM_SNAPSHOT_CONTACT);
    }
    else
    {
        memcpy(out + DEM_SNAPSHOT_CONTACT,
               c->history.saved_value + saved*(size_t)c->history.columns,
               (size_t)c->history.columns*sizeof *out);
    }
}

/* Each contact with history once: by the owner of its lower particle. */
static int list_contacts(const struct dem_particles *p, const struct dem_contacts *c,
                         uint32_t **list, size_t *n)
{
    *n = 0;
    DEM_TRY(DEM_NEW(*list, c->rows.n + c->history.saved + 1));
    for (uint32_t r = 0; r < c->rows.n; r++)
    {
        if (c->rows.pair[r] != DEM_ROW_NONE && dem_contacts_pair(c, r)->i < p->n &&
            dem_contact_history_any(&c->history, r))
        {
            (*list)[(*n)++] = r;
        }
    }
    for (size_t k = 0; k < c->history.saved; k++)
    {
        if (c->history.saved_key[k].counted)
        {
            (*list)[(*n)++] = c->rows.n + (uint32_t)k;
        }
    }
    return DEM_OK;
}

/* ---- writing --------------------------------------------------------------------------------- */

/* Collective. Write the items from byte `at` of the file on and add their checksum. */
static void write_items(struct dem_parallel_file *s, const struct items *g, size_t at,
                        uint64_t *checksum)
{
    const size_t bytes = g->size*sizeof(double), block = BLOCK/bytes + 1;
    const int64_t rounds = dem_parallel_file_max(s, (int64_t)((g->n + block - 1)/block));
    double *packed = NULL;
    const int status = DEM_NEW(packed, (g->n < block ? g->n : block)*g->size + 1);

    s->status = s->status ? s->status : status;
    for (size_t k = 0; k < (size_t)rounds; k++)
    {
        const size_t first = k*block < g->n ? k*block : g->n,
                     rest = g->n - first < block ? g->n - first : block;
        const size_t count =
            s->status ? 0 : rest;        /* a rank that has failed takes part, with nothing */

        for (size_t i = 0; i < count; i++)
        {
            g->pack(g, first + i, packed + i*g->size);
        }
        *checksum += dem_snapshot_checksum(packed, count, g->size);
        dem_parallel_file_write_all(s, at + first*bytes, packed, count*bytes);
    }
    dem_memory_free(packed);
}

/* Collective. Counts over all ranks, and over the ranks before this one. */
static void count_items(const struct dem_decomposition *q, struct dem_snapshot_header *h,
                        int64_t before[2], const size_t n[2])
{
    const int64_t own[2] = {(int64_t)n[0], (int64_t)n[1]};
    int64_t all[2] = {own[0], own[1]};

    dem_collect_sum_before(q, own, before, 2);
    dem_collect_sum_int64(q, all, 2);
    h->particles = all[0];
    h->rows = all[1];
}

static void write_caller_data(struct dem_parallel_file *store, const struct dem_snapshot *s,
                              struct dem_snapshot_header *h)
{
    struct dem_hash hash;

    dem_hash_start(&hash, 'b');
    for (int k = 0; k < s->caller_data_count; k++)
    {
        dem_parallel_file_write(store, dem_snapshot_caller_data_offset(h) + (size_t)h->caller_data,
                                s->caller_data[k].data, s->caller_data[k].size);
        dem_hash_bytes(&hash, s->caller_data[k].data, s->caller_data[k].size);
        h->caller_data += (int64_t)s->caller_data[k].size;
    }
    h->caller_data_checksum = dem_hash_value(&hash);
}

/* The first rank writes the header last, because it contains the checksums. */
static void write_header(struct dem_parallel_file *store, const struct dem_snapshot *s,
                         const struct dem_decomposition *q, struct dem_snapshot_header *h)
{
    dem_collect_sum_uint64(q, &h->checksum, 1);
    store->status = store->status ? store->status : dem_collect_status(q);
    if (q->rank == 0)
    {
        write_caller_data(store, s, h);
        h->head_checksum = dem_snapshot_header_checksum(h);
        dem_parallel_file_write(store, 0, h, sizeof *h);
    }
}

int dem_snapshot_write(const char *path, const struct dem_snapshot *s,
                       const struct dem_decomposition *q, const struct dem_interaction_table *r,
                       const struct dem_particles *p, const struct dem_contacts *c,
                       const struct dem_facet_key *wall_facet)
{
    const struct dem_file_ranks by = dem_file_ranks_of(q);
    struct dem_parallel_file store;
    struct dem_snapshot_header h;
    uint32_t *list = NULL;
    size_t n[2] = {p->n, 0};
    int64_t before[2] = {0, 0};

    memset(&h, 0, sizeof h);
    describe(&h, s, r, p);
    int status = dem_collect_agree(q, list_contacts(p, c, &list, &n[1]));

    if (status)
    {
        dem_memory_free(list);
        return status;
    }
    count_items(q, &h, before, n);
    const size_t size = dem_snapshot_particle_doubles(&h), row = dem_snapshot_contact_doubles(&h);
    const struct items particles = {.n = n[0],
                                    .size = size,
                                    .pack = pack_particle,
                                    .particles = p,
                                    .domain = s->domain};
    const struct items rows = {.n = n[1],
                               .size = row,
                               .pack = pack_contact,
                               .particles = p,
                               .contacts = c,
                               .wall_facet = wall_facet,
                               .row = list};

    status = dem_parallel_file_create(&store, &by, path, 1);
    if (!status)
    {
        write_items(&store, &particles, sizeof h + (size_t)before[0]*size*sizeof(double),
                    &h.checksum);
        write_items(&store, &rows,
                    dem_snapshot_contacts_offset(&h) + (size_t)before[1]*row*sizeof(double),
                    &h.checksum);
        write_header(&store, s, q, &h);
        status = dem_parallel_file_close(&store);
    }
    dem_memory_free(list);
    return status;
}
