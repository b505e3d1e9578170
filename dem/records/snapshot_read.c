/*
 * snapshot_read.c -- verify a snapshot completely, then read particles, the data of the caller or
 * the fingerprint.
 *
 * Contacts are read in snapshot_contacts.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/snapshot.h"
#include "core/error.h"
#include "core/memory.h"
#include "records/fingerprint.h"
#include "laws/effects.h"
#include "ranks/collect.h"
#include "core/hash.h"
#include "records/snapshot_scene.h"
#include "records/snapshot_validate.h"
#include <fenv.h>
#include <math.h>
#include <string.h>

enum
{
    CHUNK = 4096                                          /* contacts (or doubles) read at a time */
};

static int check_sum(const char *path, const struct dem_snapshot_header *h, uint64_t sum)
{
    DEM_REQUIRE(sum == h->checksum, DEM_ERROR_FILE,
                "%s is damaged: its checksum is %016llx and should be %016llx; use another one",
                path, (unsigned long long)sum, (unsigned long long)h->checksum);
    return DEM_OK;
}

/* ---- checksums ------------------------------------------------------------------------------- */

/* Add the checksum of this rank's slice of the contacts. */
static int sum_rows(struct dem_parallel_file *s, const struct dem_decomposition *q,
                    const struct dem_snapshot_header *h, uint64_t *sum)
{
    const size_t size = dem_snapshot_contact_doubles(h);
    int64_t first, rows;
    double *row;

    dem_snapshot_slice(q, h->rows, &first, &rows);
    DEM_TRY(DEM_NEW(row, CHUNK*size));
    for (int64_t at = first; at < first + rows && !s->status; at += CHUNK)
    {
        const size_t count = (size_t)(first + rows - at < CHUNK ? first + rows - at : CHUNK);

        dem_parallel_file_read(s, dem_snapshot_contacts_offset(h) + (size_t)at*size*sizeof *row,
                               row, count*size*sizeof *row);
        *sum += dem_snapshot_checksum(row, count, size);
    }
    dem_memory_free(row);
    return DEM_OK;
}

/* The caller's data have a checksum of their own. */
static int check_caller_data(struct dem_parallel_file *s, const struct dem_snapshot_header *h)
{
    struct dem_hash hash;
    double word[CHUNK];

    dem_hash_start(&hash, 'b');
    for (size_t done = 0; done < (size_t)h->caller_data && !s->status; done += sizeof word)
    {
        const size_t rest = (size_t)h->caller_data - done,
                     size = rest < sizeof word ? rest : sizeof word;

        dem_parallel_file_read(s, dem_snapshot_caller_data_offset(h) + done, word, size);
        dem_hash_bytes(&hash, word, size);
    }
    DEM_TRY(s->status);
    DEM_REQUIRE(dem_hash_value(&hash) == h->caller_data_checksum, DEM_ERROR_FILE,
                "%s is damaged: the data after its contacts have "
                "checksum %016llx and should have %016llx; use another one",
                s->path, (unsigned long long)dem_hash_value(&hash),
                (unsigned long long)h->caller_data_checksum);
    return DEM_OK;
}

/* Collective. Verify the checksum of the whole file; `sum` covers this rank's particles.
   Closes the file. */
static int verify(struct dem_parallel_file *s, const char *path, const struct dem_decomposition *q,
                  const struct dem_snapshot_header *h, uint64_t sum)
{
    int status = sum_rows(s, q, h, &sum);

    status = status || q->rank > 0 ? status : check_caller_data(s, h);
    dem_collect_sum_uint64(q, &sum, 1);
    s->status = s->status ? s->status : status;
    DEM_TRY(dem_parallel_file_close(s));
    DEM_TRY(dem_collect_agree(q, DEM_OK));
    return check_sum(path, h, sum);
}

/* ---- particles ------------------------------------------------------------------------------- */

static int map_materials(const char *path, const struct dem_snapshot_header *h,
                         const struct dem_interaction_table *r, int *material)
{
    for (int64_t k = 0; k < h->materials; k++)
    {
        DEM_TRY(dem_interaction_table_find_material(r, h->list[k].name, path, &material[k]));
    }
    return DEM_OK;
}

/* Match columns by name: a column of the scene that is not in the file stays zero. `packed`
   (the file) and `own` (this run) point behind the record. */
static void load_columns(const struct dem_particles *p, const struct dem_snapshot_header *h,
                         const double *packed, double *own)
{
    for (int64_t c = 0; c < h->columns; c++)
    {
        const char *const stored = h->list[h->materials + c].name;
        const int64_t width = h->list[h->materials + c].width;
        double *at = own;

        for (int k = 0; k < p->columns; k++)
        {
            if (p->column[k].data)
            {
                if (strcmp(p->column[k].name, stored) == 0 && p->column[k].width == width)
                {
                    memcpy(at, packed, (size_t)width*sizeof *at);
                }
                at += p->column[k].width;
            }
        }
        packed += width;
    }
}

static int load_particle(struct dem_particles *p, const struct dem_snapshot_header *h,
                         const struct dem_interaction_table *r, const int *material,
                         const double *packed, double *own, const char *path)
{
    struct dem_particle record;

    DEM_TRY(dem_snapshot_validate_particle(path, h, packed));
    memcpy(&record, packed, sizeof record);
    DEM_REQUIRE(record.material < h->materials, DEM_ERROR_FILE,
                "%s is damaged: particle %lld has no material", path, (long long)record.id);
    record.material = (uint16_t)material[record.material];
    const struct dem_material *const m = &r->material[record.material];
    const double mass = m->density*dem_particle_volume(&record);

    /* a sphere of a clump has a share of the mass of its body */
    DEM_REQUIRE(record.body || fabs(mass - record.mass) < 1e-9*mass, DEM_ERROR_INPUT,
                "%s: particle %lld of %s has density %g kg/m3, the scene says %g; make them agree",
                path, (long long)record.id, m->name, record.mass/dem_particle_volume(&record),
                m->density);
    memset(own, 0, dem_particles_packed_size(p)*sizeof *own);
    memcpy(own, &record, sizeof record);
    load_columns(p, h, packed + DEM_SNAPSHOT_RECORD, own + DEM_SNAPSHOT_RECORD);
    return dem_particles_append(p, own);
}

/* Read this rank's slice of the particles; the whole file is verified. */
static int read_slice(const char *path, const struct dem_decomposition *q,
                      struct dem_snapshot_header *h, double **packed, int64_t *count)
{
    const struct dem_file_ranks by = dem_file_ranks_of(q);
    struct dem_parallel_file store;
    int64_t first;

    *packed = NULL;
    *count = 0;
    DEM_TRY(dem_snapshot_open(&store, &by, path, h));
    dem_snapshot_slice(q, h->particles, &first, count);
    const size_t size = dem_snapshot_particle_doubles(h), n = (size_t)*count;

    store.status = DEM_NEW(*packed, n*size + 1);
    dem_parallel_file_read(&store, sizeof *h + (size_t)first*size*sizeof **packed, *packed,
                           n*size*sizeof **packed);
    return verify(&store, path, q, h, store.status ? 0 : dem_snapshot_checksum(*packed, n, size));
}

static int load_particles(struct dem_particles *p, const struct dem_snapshot_header *h,
                          const struct dem_interaction_table *r, const double *packed,
                          int64_t count, const char *path)
{
    const size_t size = dem_snapshot_particle_doubles(h);
    int material[DEM_MATERIALS], status = DEM_OK;
    double *own;

    DEM_TRY(map_materials(path, h, r, material));
    DEM_TRY(dem_particles_grow(p, (size_t)count + 1));
    DEM_TRY(DEM_NEW(own, dem_particles_packed_size(p)));
    for (int64_t i = 0; i < count && !status; i++)
    {
        status = load_particle(p, h, r, material, packed + (size_t)i*size, own, path);
    }
    dem_memory_free(own);
    return status;
}

static int has_column(const struct dem_snapshot_header *h, const char *name)
{
    int found = 0;

    for (int64_t c = 0; c < h->columns; c++)
    {
        found |= strcmp(h->list[h->materials + c].name, name) == 0;
    }
    return found;
}

/* Bit k: the file has the column of scalar k. */
static uint32_t find_scalars(const struct dem_snapshot_header *h,
                             const struct dem_interaction_table *r)
{
    uint32_t found = 0;

    for (int k = 0; k < r->scalars; k++)
    {
        found |= has_column(h, r->scalar[k]->name) ? 1U << k : 0U;
    }
    return found;
}

int dem_snapshot_read_particles(const char *path, struct dem_snapshot *s,
                                const struct dem_decomposition *q,
                                const struct dem_interaction_table *r, struct dem_particles *p)
{
    struct dem_snapshot_header h;
    double *packed;
    int64_t count;
    int status = read_slice(path, q, &h, &packed, &count);

    status = status ? status : load_particles(p, &h, r, packed, count, path);
    dem_memory_free(packed);
    DEM_TRY(status);
    DEM_REQUIRE(r->parcels.used || !has_column(&h, dem_parcel_ratio.name), DEM_ERROR_INPUT,
                "%s: its particles are parcels, but the scene has none; add parcels { ratio 1; }, "
                "their own ratios are in the snapshot", path);
    *s = (struct dem_snapshot){.particles = h.particles,
                               .rows = h.rows,
                               .steps = h.steps,
                               .time = h.time,
                               .window = h.window};
    s->scalars = find_scalars(&h, r);
    memcpy(s->skin_tuning, h.skin_tuning, sizeof s->skin_tuning);
    s->flows = h.flows;
    s->next_id = h.next_id;
    memcpy(s->flow, h.flow, sizeof s->flow);
    return DEM_OK;
}

/* ---- other data ------------------------------------------------------------------------------ */

static const struct dem_file_ranks alone = {.comm = MPI_COMM_NULL};

int dem_snapshot_read_caller_data(const char *path, void **bytes, size_t *size)
{
    struct dem_parallel_file store;
    struct dem_snapshot_header h;
    struct dem_snapshot_scene_tail tail;
    size_t scene;

    *bytes = NULL;
    *size = 0;
    DEM_TRY(dem_snapshot_open(&store, &alone, path, &h));
    store.status = dem_snapshot_scene_size(&store, &h, &tail, &scene);
    if (!store.status && (size_t)h.caller_data > scene)
    {
        *size = (size_t)h.caller_data - scene;
        store.status = dem_memory_new(bytes, *size, 1);
        dem_parallel_file_read(&store, dem_snapshot_caller_data_offset(&h), *bytes, *size);
    }
    const int status = dem_parallel_file_close(&store);

    if (status)
    {
        dem_memory_free(*bytes);
        *bytes = NULL;
        *size = 0;
    }
    return status;
}

/* Hash of the columns that are particle scalars, as in dem_hash. `packed`: behind the record. */
static uint64_t fingerprint_of_scalars(const struct dem_snapshot_header *h, int64_t id,
                                       const double *packed)
{
    uint64_t sum = 0;

    for (int64_t c = 0; c < h->columns; c++)
    {
        const char *const name = h->list[h->materials + c].name;

        sum += dem_scalar_is_known(name) ? dem_fingerprint_scalar(id, name, *packed) : 0;
        packed += h->list[h->materials + c].width;
    }
    return sum;
}

/* A wrong checksum is reported before an invalid value, which may be a consequence of the
   damage. */
static int compute_fingerprint(const char *path, uint64_t *fingerprint)
{
    struct dem_parallel_file store;
    struct dem_snapshot_header h;
    double *item = NULL;
    uint64_t sum = 0;
    int invalid = DEM_OK;

    DEM_TRY(dem_snapshot_open(&store, &alone, path, &h));
    const size_t size = dem_snapshot_particle_doubles(&h), row = dem_snapshot_contact_doubles(&h);

    store.status = DEM_NEW(item, size + row);
    *fingerprint = 0;
    for (size_t i = 0; i < (size_t)h.particles && !store.status; i++)
    {
        struct dem_particle record;

        dem_parallel_file_read(&store, sizeof h + i*size*sizeof *item, item, size*sizeof *item);
        memcpy(&record, item, sizeof record);
        sum += dem_snapshot_checksum(item, 1, size);
        invalid = invalid ? invalid : dem_snapshot_validate_particle(path, &h, item);
        *fingerprint += invalid ? 0
                                : dem_fingerprint_particle(&record) +
                                      fingerprint_of_scalars(&h, record.id,
                                                             item + DEM_SNAPSHOT_RECORD);
    }
    for (size_t k = 0; k < (size_t)h.rows && !store.status; k++)
    {
        struct dem_contact_key name;

        dem_parallel_file_read(&store, dem_snapshot_contacts_offset(&h) + k*row*sizeof *item,
                               item, row*sizeof *item);
        memcpy(&name, item, sizeof name);
        sum += dem_snapshot_checksum(item, 1, row);
        invalid = invalid ? invalid : dem_snapshot_validate_contact(path, &h, item);
        *fingerprint +=
            invalid ? 0
                    : dem_fingerprint_contact(&name, item + DEM_SNAPSHOT_CONTACT, (int)h.memories);
    }
    dem_memory_free(item);
    const int status = store.status ? DEM_OK : check_caller_data(&store, &h);

    store.status = store.status ? store.status : status;
    DEM_TRY(dem_parallel_file_close(&store));
    DEM_TRY(check_sum(path, &h, sum));
    return invalid;
}

int dem_snapshot_fingerprint(const char *path, uint64_t *fingerprint)
{
    fenv_t caller;

    feholdexcept(&caller);
    const int status = compute_fingerprint(path, fingerprint);

    fesetenv(&caller);
    return status;
}
