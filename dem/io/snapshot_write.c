/*
 * snapshot_write.c -- every rank packs its particles and the rows it counts, and writes them behind those of lower ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/snapshot.h"
#include "base/memory.h"
#include "io/snapshot_head.h"
#include "io/store.h"
#include <string.h>

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

static int put_row(double **out, size_t *room, size_t *rows, const struct dem_carried *name, const double *memory, int memories)
{
    const size_t size = DEM_SNAPSHOT_ROW + (size_t)memories;
    struct dem_carried plain;

    memset(&plain, 0, sizeof plain);
    plain.low = name->low;
    plain.high = name->high;
    plain.image = name->image;
    DEM_TRY(DEM_GROW(*out, *room, (*rows + 1)*size));
    memcpy(*out + *rows*size, &plain, sizeof plain);
    memcpy(*out + *rows*size + DEM_SNAPSHOT_ROW, memory, (size_t)memories*sizeof *memory);
    ++*rows;
    return DEM_OK;
}

/* Each remembered row once: by the owner of its lower particle. */
static int pack_rows(const struct dem_particles *p, const struct dem_contacts *c, const int *wall_region, double **out,
                     size_t *rows)
{
    double memory[DEM_MEMORY_COLUMNS];
    size_t room = 0;

    *out = NULL;
    *rows = 0;
    for (uint32_t r = 0; r < c->rows; r++)
    {
        if (c->row_pair[r] != DEM_ROW_NONE && c->pair[c->row_pair[r]].i < p->n && dem_contacts_remembers(c, r))
        {
            const struct dem_carried name = dem_contacts_name(c, p, wall_region, r);

            dem_contacts_recall(c, r, memory);
            DEM_TRY(put_row(out, &room, rows, &name, memory, c->memories));
        }
    }
    for (size_t k = 0; k < c->carried; k++)
    {
        if (c->carry[k].counted)
        {
            DEM_TRY(put_row(out, &room, rows, &c->carry[k], c->kept + k*(size_t)c->memories, c->memories));
        }
    }
    return DEM_OK;
}

/* The record comes first. Where a particle is told to be must not depend on when it was last brought back into the box. */
static int pack_particles(const struct dem_particles *p, const struct dem_domain *d, double **out)
{
    const size_t size = dem_particles_packed_size(p);

    DEM_TRY(DEM_NEW(*out, p->n*size + 1));
    for (size_t i = 0; i < p->n; i++)
    {
        struct dem_particle home = p->record[i];

        dem_particles_pack(p, i, *out + i*size);
        dem_domain_wrap(d, &home);
        memcpy(*out + i*size, &home, sizeof home);
    }
    return DEM_OK;
}

/* Counts and checksum over all ranks, and how much the ranks before this one write. */
static void place(const struct dem_pieces *q, struct dem_snapshot_head *h, int64_t before[2], int64_t particles, int64_t rows)
{
    int64_t mine[2] = {particles, rows}, all[2] = {particles, rows};

    before[0] = before[1] = 0;
    if (q->ranks > 1)
    {
        MPI_Exscan(mine, before, 2, MPI_INT64_T, MPI_SUM, q->comm);
        MPI_Allreduce(mine, all, 2, MPI_INT64_T, MPI_SUM, q->comm);
        MPI_Allreduce(MPI_IN_PLACE, &h->checksum, 1, MPI_UINT64_T, MPI_SUM, q->comm);
    }
    if (q->rank == 0)
    {
        before[0] = before[1] = 0;
    }
    h->particles = all[0];
    h->rows = all[1];
    h->head_checksum = dem_snapshot_head_check(h);
}

int dem_snapshot_write(const char *path, const struct dem_snapshot *s, const struct dem_pieces *q, const struct dem_recipe *r,
                       const struct dem_particles *p, const struct dem_contacts *c, const int *wall_region)
{
    struct dem_store store;
    struct dem_snapshot_head h;
    double *particles, *row;
    size_t rows;
    int64_t before[2];

    memset(&h, 0, sizeof h);
    describe(&h, s, r, p);
    DEM_TRY(pack_particles(p, s->domain, &particles));
    DEM_TRY(pack_rows(p, c, wall_region, &row, &rows));
    const size_t size = dem_snapshot_particle_doubles(&h), row_size = dem_snapshot_row_doubles(&h);

    h.checksum = dem_snapshot_check(particles, p->n, size) + dem_snapshot_check(row, rows, row_size);
    place(q, &h, before, (int64_t)p->n, (int64_t)rows);
    DEM_TRY(dem_store_create(&store, q->ranks > 1 ? q->comm : MPI_COMM_NULL, q->rank, path));
    if (q->rank == 0)
    {
        dem_store_write(&store, 0, &h, sizeof h);
    }
    dem_store_write(&store, sizeof h + (size_t)before[0]*size*sizeof *particles, particles, p->n*size*sizeof *particles);
    dem_store_write(&store, dem_snapshot_rows_at(&h) + (size_t)before[1]*row_size*sizeof *row, row, rows*row_size*sizeof *row);
    dem_memory_free(particles);
    dem_memory_free(row);
    return dem_store_close(&store);
}
