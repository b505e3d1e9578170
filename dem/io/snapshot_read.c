/*
 * snapshot_read.c -- a file is checked whole before anything of it is taken; particles first, rows when their owners are known.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/snapshot.h"
#include "base/error.h"
#include "base/memory.h"
#include "io/fingerprint.h"
#include "io/snapshot_head.h"
#include "io/store.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum
{
    CHUNK = 4096                                          /* rows read at a time */
};

static int read_head(struct dem_store *s, const char *path, struct dem_snapshot_head *h)
{
    memset(h->magic, 0, sizeof h->magic);
    dem_store_read(s, 0, h->magic, sizeof h->magic);      /* alone: a file of another kind may be shorter than a head */
    DEM_REQUIRE(memcmp(h->magic, dem_snapshot_magic, sizeof h->magic) == 0, DEM_ERROR_FILE, "%s is not a snapshot of Suna", path);
    dem_store_read(s, 0, h, sizeof *h);
    DEM_TRY(s->status);
    DEM_REQUIRE(h->order == dem_snapshot_order, DEM_ERROR_FILE,
                "%s was written on a machine of another byte order, or is damaged", path);
    DEM_REQUIRE(h->version == DEM_SNAPSHOT_VERSION, DEM_ERROR_FILE,
                "%s is of version %llu, this program reads version %d; write it anew", path, (unsigned long long)h->version,
                DEM_SNAPSHOT_VERSION);
    const uint64_t sum = dem_snapshot_head_check(h);

    DEM_REQUIRE(sum == h->head_checksum, DEM_ERROR_FILE,
                "%s is damaged: its head has checksum %016llx and should have %016llx; use another one", path,
                (unsigned long long)sum, (unsigned long long)h->head_checksum);
    const size_t rows = (size_t)h->rows*dem_snapshot_row_doubles(h)*sizeof(double);
    const size_t size = dem_snapshot_rows_at(h) + rows, found = dem_store_size(s);

    DEM_REQUIRE(found == size, DEM_ERROR_FILE, "%s is damaged: it has %zu bytes and should have %zu; use another one", path, found,
                size);
    return DEM_OK;
}

/* Open and read the head; closed again when that fails. */
static int open_file(struct dem_store *s, MPI_Comm comm, int rank, const char *path, struct dem_snapshot_head *h)
{
    DEM_TRY(dem_store_open(s, comm, rank, path));
    const int status = read_head(s, path, h);

    if (status)
    {
        s->status = status;                               /* the sentence that counts has been said */
        (void)dem_store_close(s);
    }
    return status;
}

static int agrees(const char *path, const struct dem_snapshot_head *h, uint64_t sum)
{
    DEM_REQUIRE(sum == h->checksum, DEM_ERROR_FILE, "%s is damaged: its checksum is %016llx and should be %016llx; use another one",
                path, (unsigned long long)sum, (unsigned long long)h->checksum);
    return DEM_OK;
}

/* One word of the file after the other: the checksum needs every rank's share. */
static int verify(struct dem_store *s, const char *path, const struct dem_pieces *q, const struct dem_snapshot_head *h,
                  uint64_t sum)
{
    const size_t size = dem_snapshot_row_doubles(h);
    double *row;

    DEM_TRY(DEM_NEW(row, CHUNK*size));
    for (int64_t at = q->rank*(int64_t)CHUNK; at < h->rows && !s->status; at += q->ranks*(int64_t)CHUNK)
    {
        const size_t count = (size_t)(h->rows - at < CHUNK ? h->rows - at : CHUNK);

        dem_store_read(s, dem_snapshot_rows_at(h) + (size_t)at*size*sizeof *row, row, count*size*sizeof *row);
        sum += dem_snapshot_check(row, count, size);
    }
    dem_memory_free(row);
    if (q->ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_UINT64_T, MPI_SUM, q->comm);
    }
    DEM_TRY(dem_store_close(s));
    return agrees(path, h, sum);
}

static int map_materials(const char *path, const struct dem_snapshot_head *h, const struct dem_recipe *r, int *material)
{
    for (int64_t k = 0; k < h->materials; k++)
    {
        DEM_TRY(dem_recipe_material(r, h->list[k].name, path, &material[k]));
    }
    return DEM_OK;
}

/* Columns by name: what the scene has and the file lacks stays zero. `packed` and `mine` start behind the record. */
static void take_columns(const struct dem_particles *p, const struct dem_snapshot_head *h, const double *packed, double *mine)
{
    for (int64_t c = 0; c < h->columns; c++)
    {
        const char *const name = h->list[h->materials + c].name;
        const int64_t width = h->list[h->materials + c].width;
        double *at = mine;

        for (int k = 0; k < DEM_COLUMNS; k++)
        {
            if (p->column[k].data)
            {
                if (strcmp(p->column[k].name, name) == 0 && p->column[k].width == width)
                {
                    memcpy(at, packed, (size_t)width*sizeof *at);
                }
                at += p->column[k].width;
            }
        }
        packed += width;
    }
}

static int take_particle(struct dem_particles *p, const struct dem_snapshot_head *h, const struct dem_recipe *r,
                         const int *material, const double *packed, double *mine, const char *path)
{
    struct dem_particle record;

    memcpy(&record, packed, sizeof record);
    DEM_REQUIRE(record.material < h->materials, DEM_ERROR_FILE, "%s is damaged: particle %lld has no material", path,
                (long long)record.id);
    record.material = (uint16_t)material[record.material];
    const struct dem_material *const m = &r->material[record.material];
    const double mass = m->density*dem_particle_volume(&record);

    DEM_REQUIRE(fabs(mass - record.mass) < 1e-9*mass, DEM_ERROR_INPUT,
                "%s: particle %lld of %s has density %g kg/m3, the scene says %g; make them agree", path, (long long)record.id,
                m->name, record.mass/dem_particle_volume(&record), m->density);
    memset(mine, 0, dem_particles_packed_size(p)*sizeof *mine);
    memcpy(mine, &record, sizeof record);
    take_columns(p, h, packed + DEM_SNAPSHOT_RECORD, mine + DEM_SNAPSHOT_RECORD);
    return dem_particles_append(p, mine);
}

int dem_snapshot_read_particles(const char *path, struct dem_snapshot *s, const struct dem_pieces *q, const struct dem_recipe *r,
                                struct dem_particles *p)
{
    struct dem_store store;
    struct dem_snapshot_head h;
    int material[DEM_MATERIALS];
    double *packed, *mine;

    DEM_TRY(open_file(&store, q->ranks > 1 ? q->comm : MPI_COMM_NULL, q->rank, path, &h));
    DEM_TRY(map_materials(path, &h, r, material));
    const int64_t first = h.particles*q->rank/q->ranks, end = h.particles*(q->rank + 1)/q->ranks;
    const size_t size = dem_snapshot_particle_doubles(&h), count = (size_t)(end - first);

    DEM_TRY(dem_particles_grow(p, 1));
    DEM_TRY(DEM_NEW(packed, count*size + 1));
    DEM_TRY(DEM_NEW(mine, dem_particles_packed_size(p)));
    dem_store_read(&store, sizeof h + (size_t)first*size*sizeof *packed, packed, count*size*sizeof *packed);
    DEM_TRY(verify(&store, path, q, &h, dem_snapshot_check(packed, count, size)));
    for (size_t i = 0; i < count; i++)
    {
        DEM_TRY(take_particle(p, &h, r, material, packed + i*size, mine, path));
    }
    dem_memory_free(packed);
    dem_memory_free(mine);
    *s = (struct dem_snapshot){.particles = h.particles, .rows = h.rows, .steps = h.steps, .time = h.time, .checksum = h.checksum};
    return DEM_OK;
}

/* ---- rows ---------------------------------------------------------------------------------------------------- */

static int compare_ids(const void *a, const void *b)
{
    const int64_t p = *(const int64_t *)a, q = *(const int64_t *)b;

    return (p > q) - (p < q);
}

static int owned(const int64_t *id, size_t n, int64_t wanted)
{
    return n > 0 && wanted >= 0 && bsearch(&wanted, id, n, sizeof *id, compare_ids) != NULL;
}

static int take_row(struct dem_contacts *c, const struct dem_snapshot_head *h, const struct dem_recipe *r, const double *row,
                    const int64_t *id, size_t n)
{
    double memory[DEM_MEMORY_COLUMNS] = {0.0};
    struct dem_carried name;

    memcpy(&name, row, sizeof name);
    name.counted = (uint32_t)owned(id, n, name.low);
    for (int64_t k = 0; k < h->memories; k++)
    {
        const char *const column = h->list[h->materials + h->columns + k].name;

        for (int m = 0; m < r->memories; m++)
        {
            memory[m] = strcmp(r->memory[m], column) == 0 ? row[DEM_SNAPSHOT_ROW + k] : memory[m];
        }
    }
    return name.counted || owned(id, n, name.high) ? dem_contacts_carry(c, &name, memory) : DEM_OK;
}

/* Every rank looks at all rows and takes those of its own particles. */
int dem_snapshot_read_rows(const char *path, const struct dem_recipe *r, const struct dem_particles *p, struct dem_contacts *c)
{
    struct dem_store store;
    struct dem_snapshot_head h;
    int64_t *id;
    double *row;

    DEM_TRY(open_file(&store, MPI_COMM_NULL, 0, path, &h));
    const size_t size = dem_snapshot_row_doubles(&h);

    DEM_TRY(DEM_NEW(id, p->n + 1));
    DEM_TRY(DEM_NEW(row, CHUNK*size));
    for (size_t i = 0; i < p->n; i++)
    {
        id[i] = p->record[i].id;
    }
    qsort(id, p->n, sizeof *id, compare_ids);
    for (int64_t at = 0; at < h.rows && !store.status; at += CHUNK)
    {
        const size_t count = (size_t)(h.rows - at < CHUNK ? h.rows - at : CHUNK);

        dem_store_read(&store, dem_snapshot_rows_at(&h) + (size_t)at*size*sizeof *row, row, count*size*sizeof *row);
        for (size_t k = 0; k < count && !store.status; k++)
        {
            DEM_TRY(take_row(c, &h, r, row + k*size, id, p->n));
        }
    }
    dem_memory_free(id);
    dem_memory_free(row);
    return dem_store_close(&store);
}

int dem_snapshot_fingerprint(const char *path, uint64_t *fingerprint)
{
    struct dem_store store;
    struct dem_snapshot_head h;
    double *item;
    uint64_t sum = 0;

    DEM_TRY(open_file(&store, MPI_COMM_NULL, 0, path, &h));
    const size_t size = dem_snapshot_particle_doubles(&h), row = dem_snapshot_row_doubles(&h);

    DEM_TRY(DEM_NEW(item, size + row));
    *fingerprint = 0;
    for (size_t i = 0; i < (size_t)h.particles && !store.status; i++)
    {
        struct dem_particle record;

        dem_store_read(&store, sizeof h + i*size*sizeof *item, item, size*sizeof *item);
        memcpy(&record, item, sizeof record);
        sum += dem_snapshot_check(item, 1, size);
        *fingerprint += dem_fingerprint_particle(&record);
    }
    for (size_t k = 0; k < (size_t)h.rows && !store.status; k++)
    {
        struct dem_carried name;

        dem_store_read(&store, dem_snapshot_rows_at(&h) + k*row*sizeof *item, item, row*sizeof *item);
        memcpy(&name, item, sizeof name);
        sum += dem_snapshot_check(item, 1, row);
        *fingerprint += dem_fingerprint_row(&name, item + DEM_SNAPSHOT_ROW, (int)h.memories);
    }
    dem_memory_free(item);
    DEM_TRY(dem_store_close(&store));
    return agrees(path, &h, sum);
}
