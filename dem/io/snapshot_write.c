/*
 * snapshot_write.c -- every rank packs its particles and the rows it counts, block by block, and writes them behind those of
 * lower ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/snapshot.h"
#include "base/error.h"
#include "base/memory.h"
#include "io/hash.h"
#include "io/snapshot_head.h"
#include <string.h>

enum
{
    BLOCK = 1 << 24                                       /* bytes packed before they are written */
};

/* ---- the head -------------------------------------------------------------------------------------------------- */

static void list_name(struct dem_snapshot_head *h, int64_t at, const char *name, int width)
{
    strncpy(h->list[at].name, name, DEM_SNAPSHOT_NAME - 1);
    h->list[at].width = width;
}

static void describe(struct dem_snapshot_head *h, const struct dem_snapshot *s, const struct dem_recipe *r,
                     const struct dem_particles *p)
{
    memcpy(h->magic, dem_snapshot_magic, sizeof dem_snapshot_magic);
    h->order = dem_snapshot_order;
    h->version = DEM_SNAPSHOT_VERSION;
    h->steps = s->steps;
    h->time = s->time;
    h->window = s->window;
    memcpy(h->learnt, s->learnt, sizeof h->learnt);
    h->flows = s->flows;
    h->next_id = s->next_id;
    memcpy(h->flow, s->flow, (size_t)s->flows*sizeof *h->flow);
    for (int k = 0; k < r->materials; k++)
    {
        list_name(h, h->materials++, r->material[k].name, 0);
    }
    for (int c = 0; c < DEM_COLUMNS; c++)
    {
        if (p->column[c].data)
        {
            list_name(h, h->materials + h->columns++, p->column[c].name, p->column[c].width);
        }
    }
    for (int m = 0; m < r->memories; m++)
    {
        list_name(h, h->materials + h->columns + h->memories++, r->memory[m], 1);
    }
}

/* ---- items ----------------------------------------------------------------------------------------------------- */

struct cargo                                              /* what one rank has to write, particles or rows */
{
    size_t n, size;                                       /* items, doubles of one */
    void (*pack)(const struct cargo *, size_t k, double *out);
    const struct dem_particles *particles;
    const struct dem_domain *domain;
    const struct dem_contacts *contacts;
    const int *wall_region;
    const uint32_t *row;                                  /* near rows, then carried ones counted from contacts->rows */
};

/* The record comes first. Where a particle is told to be must not depend on when it was last brought back into the box. */
static void pack_particle(const struct cargo *g, size_t k, double *out)
{
    struct dem_particle home = g->particles->record[k];

    dem_particles_pack(g->particles, k, out);
    dem_domain_wrap(g->domain, &home);
    memcpy(out, &home, sizeof home);
}

static void pack_row(const struct cargo *g, size_t k, double *out)
{
    const struct dem_contacts *const c = g->contacts;
    const int near = g->row[k] < c->rows;
    const size_t carried = near ? 0 : g->row[k] - c->rows;
    const struct dem_carried name = near ? dem_contacts_name(c, g->particles, g->wall_region, g->row[k]) : c->carry[carried];
    struct dem_carried plain;

    memset(&plain, 0, sizeof plain);
    plain.low = name.low;
    plain.high = name.high;
    plain.image = name.image;
    memcpy(out, &plain, sizeof plain);
    if (near)
    {
        dem_contacts_recall(c, g->row[k], out + DEM_SNAPSHOT_ROW);
    }
    else
    {
        memcpy(out + DEM_SNAPSHOT_ROW, c->kept + carried*(size_t)c->memories, (size_t)c->memories*sizeof *out);
    }
}

/* Each remembered row once: by the owner of its lower particle. */
static int list_rows(const struct dem_particles *p, const struct dem_contacts *c, uint32_t **list, size_t *n)
{
    *n = 0;
    DEM_TRY(DEM_NEW(*list, c->rows + c->carried + 1));
    for (uint32_t r = 0; r < c->rows; r++)
    {
        if (c->row_pair[r] != DEM_ROW_NONE && c->pair[c->row_pair[r]].i < p->n && dem_contacts_remembers(c, r))
        {
            (*list)[(*n)++] = r;
        }
    }
    for (size_t k = 0; k < c->carried; k++)
    {
        if (c->carry[k].counted)
        {
            (*list)[(*n)++] = c->rows + (uint32_t)k;
        }
    }
    return DEM_OK;
}

/* ---- writing --------------------------------------------------------------------------------------------------- */

/* Collective. Items from byte `at` of the file on; their checksum. */
static int write_cargo(struct dem_store *s, const struct cargo *g, size_t at, uint64_t *checksum)
{
    const size_t bytes = g->size*sizeof(double), block = BLOCK/bytes + 1;
    int64_t rounds = (int64_t)((g->n + block - 1)/block);
    double *packed;

    if (s->by.comm != MPI_COMM_NULL)
    {
        MPI_Allreduce(MPI_IN_PLACE, &rounds, 1, MPI_INT64_T, MPI_MAX, s->by.comm);
    }
    DEM_TRY(DEM_NEW(packed, (g->n < block ? g->n : block)*g->size + 1));
    for (size_t k = 0; k < (size_t)rounds; k++)
    {
        const size_t first = k*block < g->n ? k*block : g->n, count = g->n - first < block ? g->n - first : block;

        for (size_t i = 0; i < count; i++)
        {
            g->pack(g, first + i, packed + i*g->size);
        }
        *checksum += dem_snapshot_check(packed, count, g->size);
        dem_store_write_together(s, at + first*bytes, packed, count*bytes);
    }
    dem_memory_free(packed);
    return DEM_OK;
}

/* Counts over all ranks, and how much the ranks before this one write. */
static void place(const struct dem_pieces *q, struct dem_snapshot_head *h, int64_t before[2], const size_t n[2])
{
    const int64_t mine[2] = {(int64_t)n[0], (int64_t)n[1]};
    int64_t all[2] = {mine[0], mine[1]};

    if (q->ranks > 1)
    {
        MPI_Exscan(mine, before, 2, MPI_INT64_T, MPI_SUM, q->comm);
        MPI_Allreduce(mine, all, 2, MPI_INT64_T, MPI_SUM, q->comm);
    }
    if (q->rank == 0)
    {
        before[0] = before[1] = 0;
    }
    h->particles = all[0];
    h->rows = all[1];
}

static void write_beside(struct dem_store *store, const struct dem_snapshot *s, struct dem_snapshot_head *h)
{
    struct dem_hash hash;

    dem_hash_start(&hash, 'b');
    for (int k = 0; k < s->besides; k++)
    {
        dem_store_write(store, dem_snapshot_beside_at(h) + (size_t)h->beside, s->beside[k].data, s->beside[k].size);
        dem_hash_bytes(&hash, s->beside[k].data, s->beside[k].size);
        h->beside += (int64_t)s->beside[k].size;
    }
    h->beside_checksum = dem_hash_value(&hash);
}

/* The head last, by the first rank: it holds the sums. */
static void write_head(struct dem_store *store, const struct dem_snapshot *s, const struct dem_pieces *q, struct dem_snapshot_head *h)
{
    if (q->ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, &h->checksum, 1, MPI_UINT64_T, MPI_SUM, q->comm);
    }
    if (q->rank == 0)
    {
        write_beside(store, s, h);
        h->head_checksum = dem_snapshot_head_check(h);
        dem_store_write(store, 0, h, sizeof *h);
    }
}

int dem_snapshot_write(const char *path, const struct dem_snapshot *s, const struct dem_pieces *q, const struct dem_recipe *r,
                       const struct dem_particles *p, const struct dem_contacts *c, const int *wall_region)
{
    struct dem_store store;
    struct dem_snapshot_head h;
    uint32_t *list;
    size_t n[2] = {p->n, 0};
    int64_t before[2];

    memset(&h, 0, sizeof h);
    describe(&h, s, r, p);
    DEM_TRY(list_rows(p, c, &list, &n[1]));
    place(q, &h, before, n);
    const size_t size = dem_snapshot_particle_doubles(&h), row = dem_snapshot_row_doubles(&h);
    const struct cargo particles = {.n = n[0], .size = size, .pack = pack_particle, .particles = p, .domain = s->domain};
    const struct cargo rows = {.n = n[1], .size = row, .pack = pack_row, .particles = p, .contacts = c, .wall_region = wall_region,
                               .row = list};

    DEM_TRY(dem_store_create(&store, &(const struct dem_writers){.comm = q->ranks > 1 ? q->comm : MPI_COMM_NULL, .rank = q->rank}, path, 1));
    DEM_TRY(write_cargo(&store, &particles, sizeof h + (size_t)before[0]*size*sizeof(double), &h.checksum));
    DEM_TRY(write_cargo(&store, &rows, dem_snapshot_rows_at(&h) + (size_t)before[1]*row*sizeof(double), &h.checksum));
    write_head(&store, s, q, &h);
    dem_memory_free(list);
    return dem_store_close(&store);
}
