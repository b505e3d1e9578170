/*
 * snapshot_read.c -- a file is checked whole before anything of it is taken: particles, what is the caller's, the fingerprint.
 * Rows are in snapshot_rows.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/snapshot.h"
#include "base/error.h"
#include "base/memory.h"
#include "io/fingerprint.h"
#include "io/hash.h"
#include "io/snapshot_judge.h"
#include <fenv.h>
#include <math.h>
#include <string.h>

enum
{
    CHUNK = 4096                                          /* rows read at a time */
};

static int agrees(const char *path, const struct dem_snapshot_head *h, uint64_t sum)
{
    DEM_REQUIRE(sum == h->checksum, DEM_ERROR_FILE, "%s is damaged: its checksum is %016llx and should be %016llx; use another one",
                path, (unsigned long long)sum, (unsigned long long)h->checksum);
    return DEM_OK;
}

/* ---- verifying ------------------------------------------------------------------------------------------------- */

/* The sum over this rank's share of the rows. */
static int sum_rows(struct dem_store *s, const struct dem_pieces *q, const struct dem_snapshot_head *h, uint64_t *sum)
{
    const size_t size = dem_snapshot_row_doubles(h);
    int64_t first, rows;
    double *row;

    dem_snapshot_share(q, h->rows, &first, &rows);
    DEM_TRY(DEM_NEW(row, CHUNK*size));
    for (int64_t at = first; at < first + rows && !s->status; at += CHUNK)
    {
        const size_t count = (size_t)(first + rows - at < CHUNK ? first + rows - at : CHUNK);

        dem_store_read(s, dem_snapshot_rows_at(h) + (size_t)at*size*sizeof *row, row, count*size*sizeof *row);
        *sum += dem_snapshot_check(row, count, size);
    }
    dem_memory_free(row);
    return DEM_OK;
}

/* What is the caller's has a sum of its own. */
static int check_beside(struct dem_store *s, const struct dem_snapshot_head *h)
{
    struct dem_hash hash;
    double word[CHUNK];

    dem_hash_start(&hash, 'b');
    for (size_t done = 0; done < (size_t)h->beside && !s->status; done += sizeof word)
    {
        const size_t rest = (size_t)h->beside - done, size = rest < sizeof word ? rest : sizeof word;

        dem_store_read(s, dem_snapshot_beside_at(h) + done, word, size);
        dem_hash_bytes(&hash, word, size);
    }
    DEM_TRY(s->status);
    DEM_REQUIRE(dem_hash_value(&hash) == h->beside_checksum, DEM_ERROR_FILE, "%s is damaged: what stands behind its contacts has "
                "checksum %016llx and should have %016llx; use another one", s->path, (unsigned long long)dem_hash_value(&hash),
                (unsigned long long)h->beside_checksum);
    return DEM_OK;
}

/* Collective. Every rank sums its share; `sum` is that of its particles. Closes the file. */
static int verify(struct dem_store *s, const char *path, const struct dem_pieces *q, const struct dem_snapshot_head *h,
                  uint64_t sum)
{
    int status = sum_rows(s, q, h, &sum);

    status = status || q->rank > 0 ? status : check_beside(s, h);
    if (q->ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_UINT64_T, MPI_SUM, q->comm);
    }
    s->status = s->status ? s->status : status;
    DEM_TRY(dem_store_close(s));
    return agrees(path, h, sum);
}

/* ---- particles ------------------------------------------------------------------------------------------------- */

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

    DEM_TRY(dem_snapshot_judge_particle(path, h, packed));
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

/* This rank's share into memory; all of the file is verified. */
static int read_share(const char *path, const struct dem_pieces *q, struct dem_snapshot_head *h, double **packed, int64_t *count)
{
    struct dem_store store;
    int64_t first;

    *packed = NULL;
    *count = 0;
    DEM_TRY(dem_snapshot_open(&store, &(const struct dem_writers){.comm = q->ranks > 1 ? q->comm : MPI_COMM_NULL, .rank = q->rank}, path, h));
    dem_snapshot_share(q, h->particles, &first, count);
    const size_t size = dem_snapshot_particle_doubles(h), n = (size_t)*count;

    store.status = DEM_NEW(*packed, n*size + 1);
    dem_store_read(&store, sizeof *h + (size_t)first*size*sizeof **packed, *packed, n*size*sizeof **packed);
    return verify(&store, path, q, h, store.status ? 0 : dem_snapshot_check(*packed, n, size));
}

static int take_particles(struct dem_particles *p, const struct dem_snapshot_head *h, const struct dem_recipe *r, const double *packed,
                          int64_t count, const char *path)
{
    const size_t size = dem_snapshot_particle_doubles(h);
    int material[DEM_MATERIALS], status = DEM_OK;
    double *mine;

    DEM_TRY(map_materials(path, h, r, material));
    DEM_TRY(dem_particles_grow(p, (size_t)count + 1));
    DEM_TRY(DEM_NEW(mine, dem_particles_packed_size(p)));
    for (int64_t i = 0; i < count && !status; i++)
    {
        status = take_particle(p, h, r, material, packed + (size_t)i*size, mine, path);
    }
    dem_memory_free(mine);
    return status;
}

int dem_snapshot_read_particles(const char *path, struct dem_snapshot *s, const struct dem_pieces *q, const struct dem_recipe *r,
                                struct dem_particles *p)
{
    struct dem_snapshot_head h;
    double *packed;
    int64_t count;
    int status = read_share(path, q, &h, &packed, &count);

    status = status ? status : take_particles(p, &h, r, packed, count, path);
    dem_memory_free(packed);
    *s = (struct dem_snapshot){.particles = h.particles, .rows = h.rows, .steps = h.steps, .time = h.time, .window = h.window};
    memcpy(s->learnt, h.learnt, sizeof s->learnt);
    s->flows = h.flows;
    s->next_id = h.next_id;
    memcpy(s->flow, h.flow, sizeof s->flow);
    return status;
}

/* ---- the rest -------------------------------------------------------------------------------------------------- */

static const struct dem_writers alone = {.comm = MPI_COMM_NULL};

int dem_snapshot_read_beside(const char *path, void **bytes, size_t *size)
{
    struct dem_store store;
    struct dem_snapshot_head h;

    *bytes = NULL;
    *size = 0;
    DEM_TRY(dem_snapshot_open(&store, &alone, path, &h));
    if (h.beside > 0)
    {
        store.status = dem_memory_new(bytes, (size_t)h.beside, 1);
        dem_store_read(&store, dem_snapshot_beside_at(&h), *bytes, (size_t)h.beside);
        *size = (size_t)h.beside;
    }
    return dem_store_close(&store);
}

/* What is damaged by its checksum is told as such; what is not may still hold what no run has written. */
static int take_fingerprint(const char *path, uint64_t *fingerprint)
{
    struct dem_store store;
    struct dem_snapshot_head h;
    double *item;
    uint64_t sum = 0;
    int absurd = DEM_OK;

    DEM_TRY(dem_snapshot_open(&store, &alone, path, &h));
    const size_t size = dem_snapshot_particle_doubles(&h), row = dem_snapshot_row_doubles(&h);

    DEM_TRY(DEM_NEW(item, size + row));
    *fingerprint = 0;
    for (size_t i = 0; i < (size_t)h.particles && !store.status; i++)
    {
        struct dem_particle record;

        dem_store_read(&store, sizeof h + i*size*sizeof *item, item, size*sizeof *item);
        memcpy(&record, item, sizeof record);
        sum += dem_snapshot_check(item, 1, size);
        absurd = absurd ? absurd : dem_snapshot_judge_particle(path, &h, item);
        *fingerprint += absurd ? 0 : dem_fingerprint_particle(&record);
    }
    for (size_t k = 0; k < (size_t)h.rows && !store.status; k++)
    {
        struct dem_carried name;

        dem_store_read(&store, dem_snapshot_rows_at(&h) + k*row*sizeof *item, item, row*sizeof *item);
        memcpy(&name, item, sizeof name);
        sum += dem_snapshot_check(item, 1, row);
        absurd = absurd ? absurd : dem_snapshot_judge_row(path, &h, item);
        *fingerprint += absurd ? 0 : dem_fingerprint_row(&name, item + DEM_SNAPSHOT_ROW, (int)h.memories);
    }
    dem_memory_free(item);
    const int status = store.status ? DEM_OK : check_beside(&store, &h);

    store.status = store.status ? store.status : status;
    DEM_TRY(dem_store_close(&store));
    DEM_TRY(agrees(path, &h, sum));
    return absurd;
}

int dem_snapshot_fingerprint(const char *path, uint64_t *fingerprint)
{
    fenv_t caller;

    feholdexcept(&caller);
    const int status = take_fingerprint(path, fingerprint);

    fesetenv(&caller);
    return status;
}
