/*
 * snapshot.c -- head, particles, rows.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/snapshot.h"
#include "base/error.h"
#include "base/memory.h"
#include "io/fingerprint.h"
#include "io/hash.h"
#include "io/store.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum
{
    VERSION = 2,
    NAME = 48,
    RECORD = (int)(sizeof(struct dem_particle)/sizeof(double)),
    ROW_NAME = (int)(sizeof(struct dem_carried)/sizeof(double)),
    CHUNK = 4096,                                         /* rows read at a time */
    NAMES = 128                                           /* a fixed number, so that a new column moves nothing in the file */
};

static const char magic[8] = "SUNADEM";
static const uint64_t byte_order = 0x0102030405060708u;

struct head
{
    char magic[8];
    uint64_t order, version, checksum, head_checksum;     /* of particles and rows; of this head without itself */
    int64_t particles, rows, steps;
    double time;
    int64_t materials, columns, memories;
    struct
    {
        char name[NAME];
        int64_t width;
    } list[NAMES];                                        /* materials, columns, memory */
};
_Static_assert(DEM_MATERIALS + DEM_COLUMNS + DEM_MEMORY_COLUMNS <= NAMES, "the head has room for all names");

static size_t particle_doubles(const struct head *h)
{
    size_t size = RECORD;

    for (int64_t c = 0; c < h->columns; c++)
    {
        size += (size_t)h->list[h->materials + c].width;
    }
    return size;
}

static size_t row_doubles(const struct head *h)
{
    return ROW_NAME + (size_t)h->memories;
}

static size_t rows_at(const struct head *h)
{
    return sizeof *h + (size_t)h->particles*particle_doubles(h)*sizeof(double);
}

static uint64_t head_check(const struct head *h)
{
    struct head plain = *h;

    plain.head_checksum = 0;
    return dem_hash_record(&plain, sizeof plain, 'h');
}

/* ---- writing ------------------------------------------------------------------------------------------------- */

static void list_name(struct head *h, int64_t at, const char *name, int width)
{
    strncpy(h->list[at].name, name, NAME - 1);
    h->list[at].width = width;
}

static void describe(struct head *h, const struct dem_snapshot *s, const struct dem_recipe *r, const struct dem_particles *p)
{
    memcpy(h->magic, magic, sizeof magic);
    h->order = byte_order;
    h->version = VERSION;
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
    const size_t size = ROW_NAME + (size_t)memories;
    struct dem_carried plain;

    memset(&plain, 0, sizeof plain);
    plain.low = name->low;
    plain.high = name->high;
    plain.image = name->image;
    DEM_TRY(DEM_GROW(*out, *room, (*rows + 1)*size));
    memcpy(*out + *rows*size, &plain, sizeof plain);
    memcpy(*out + *rows*size + ROW_NAME, memory, (size_t)memories*sizeof *memory);
    ++*rows;
    return DEM_OK;
}

/* Each remembered row once: by the owner of its lower particle. */
static int pack_rows(const struct dem_particles *p, const struct dem_contacts *c, const int *wall_region, double **out, size_t *rows)
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

static int pack_particles(const struct dem_particles *p, double **out)
{
    const size_t size = dem_particles_packed_size(p);

    DEM_TRY(DEM_NEW(*out, p->n*size + 1));
    for (size_t i = 0; i < p->n; i++)
    {
        dem_particles_pack(p, i, *out + i*size);
    }
    return DEM_OK;
}

static uint64_t check(const double *data, size_t count, size_t size)
{
    uint64_t sum = 0;

    for (size_t k = 0; k < count; k++)
    {
        sum += dem_hash_record(data + k*size, size*sizeof *data, size);
    }
    return sum;
}

/* Counts and checksum over all ranks, and how much the ranks before this one write. */
static void place(const struct dem_pieces *q, struct head *h, int64_t before[2], int64_t particles, int64_t rows)
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
    h->head_checksum = head_check(h);
}

int dem_snapshot_write(const char *path, const struct dem_snapshot *s, const struct dem_pieces *q, const struct dem_recipe *r,
                       const struct dem_particles *p, const struct dem_contacts *c, const int *wall_region)
{
    struct dem_store store;
    struct head h;
    double *particles, *row;
    size_t rows;
    int64_t before[2];

    memset(&h, 0, sizeof h);
    describe(&h, s, r, p);
    DEM_TRY(pack_particles(p, &particles));
    DEM_TRY(pack_rows(p, c, wall_region, &row, &rows));
    h.checksum = check(particles, p->n, particle_doubles(&h)) + check(row, rows, row_doubles(&h));
    place(q, &h, before, (int64_t)p->n, (int64_t)rows);
    DEM_TRY(dem_store_create(&store, q->ranks > 1 ? q->comm : MPI_COMM_NULL, q->rank, path));
    if (q->rank == 0)
    {
        dem_store_write(&store, 0, &h, sizeof h);
    }
    dem_store_write(&store, sizeof h + (size_t)before[0]*particle_doubles(&h)*sizeof(double), particles,
                    p->n*particle_doubles(&h)*sizeof(double));
    dem_store_write(&store, rows_at(&h) + (size_t)before[1]*row_doubles(&h)*sizeof(double), row,
                    rows*row_doubles(&h)*sizeof(double));
    dem_memory_free(particles);
    dem_memory_free(row);
    return dem_store_close(&store);
}

/* ---- reading ------------------------------------------------------------------------------------------------- */

static int read_head(struct dem_store *s, const char *path, struct head *h)
{
    memset(h->magic, 0, sizeof h->magic);
    dem_store_read(s, 0, h->magic, sizeof h->magic);      /* alone: a file of another kind may be shorter than a head */
    DEM_REQUIRE(memcmp(h->magic, magic, sizeof magic) == 0, DEM_ERROR_FILE, "%s is not a snapshot of Suna", path);
    dem_store_read(s, 0, h, sizeof *h);
    DEM_TRY(s->status);
    DEM_REQUIRE(h->order == byte_order, DEM_ERROR_FILE, "%s was written on a machine of another byte order, or is damaged", path);
    DEM_REQUIRE(h->version == VERSION, DEM_ERROR_FILE, "%s is of version %llu, this program reads version %d; write it anew", path,
                (unsigned long long)h->version, VERSION);
    DEM_REQUIRE(head_check(h) == h->head_checksum, DEM_ERROR_FILE, "%s is damaged: its head has checksum %016llx and should have "
                "%016llx; use another one", path, (unsigned long long)head_check(h), (unsigned long long)h->head_checksum);
    const size_t size = rows_at(h) + (size_t)h->rows*row_doubles(h)*sizeof(double), found = dem_store_size(s);

    DEM_REQUIRE(found == size, DEM_ERROR_FILE, "%s is damaged: it has %zu bytes and should have %zu; use another one", path, found,
                size);
    return DEM_OK;
}

/* Open and read the head; closed again when that fails. */
static int open_file(struct dem_store *s, MPI_Comm comm, int rank, const char *path, struct head *h)
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

static int agrees(const char *path, const struct head *h, uint64_t sum)
{
    DEM_REQUIRE(sum == h->checksum, DEM_ERROR_FILE, "%s is damaged: its checksum is %016llx and should be %016llx; use another one",
                path, (unsigned long long)sum, (unsigned long long)h->checksum);
    return DEM_OK;
}

/* One word of the file after the other: the checksum needs every rank's share. */
static int verify(struct dem_store *s, const char *path, const struct dem_pieces *q, const struct head *h, uint64_t sum)
{
    const size_t size = row_doubles(h);
    double *row;

    DEM_TRY(DEM_NEW(row, CHUNK*size));
    for (int64_t at = q->rank*(int64_t)CHUNK; at < h->rows && !s->status; at += q->ranks*(int64_t)CHUNK)
    {
        const size_t count = (size_t)(h->rows - at < CHUNK ? h->rows - at : CHUNK);

        dem_store_read(s, rows_at(h) + (size_t)at*size*sizeof *row, row, count*size*sizeof *row);
        sum += check(row, count, size);
    }
    dem_memory_free(row);
    if (q->ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_UINT64_T, MPI_SUM, q->comm);
    }
    DEM_TRY(dem_store_close(s));
    return agrees(path, h, sum);
}

static int map_materials(const char *path, const struct head *h, const struct dem_recipe *r, int *material)
{
    for (int64_t k = 0; k < h->materials; k++)
    {
        DEM_TRY(dem_recipe_material(r, h->list[k].name, path, &material[k]));
    }
    return DEM_OK;
}

static int take_particle(struct dem_particles *p, const struct head *h, const struct dem_recipe *r, const int *material,
                         const double *packed, double *mine, const char *path)
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
    packed += RECORD;
    for (int64_t c = 0; c < h->columns; c++)
    {
        double *at = mine + RECORD;

        for (int k = 0; k < DEM_COLUMNS; k++)
        {
            if (p->column[k].data)
            {
                if (strcmp(p->column[k].name, h->list[h->materials + c].name) == 0 && p->column[k].width == h->list[h->materials + c].width)
                {
                    memcpy(at, packed, (size_t)p->column[k].width*sizeof *at);
                }
                at += p->column[k].width;
            }
        }
        packed += h->list[h->materials + c].width;
    }
    return dem_particles_append(p, mine);
}

int dem_snapshot_read_particles(const char *path, struct dem_snapshot *s, const struct dem_pieces *q, const struct dem_recipe *r,
                                struct dem_particles *p)
{
    struct dem_store store;
    struct head h;
    int material[DEM_MATERIALS];
    double *packed, *mine;

    DEM_TRY(open_file(&store, q->ranks > 1 ? q->comm : MPI_COMM_NULL, q->rank, path, &h));
    DEM_TRY(map_materials(path, &h, r, material));
    const int64_t first = h.particles*q->rank/q->ranks, end = h.particles*(q->rank + 1)/q->ranks;
    const size_t size = particle_doubles(&h), count = (size_t)(end - first);

    DEM_TRY(dem_particles_grow(p, 1));
    DEM_TRY(DEM_NEW(packed, count*size + 1));
    DEM_TRY(DEM_NEW(mine, dem_particles_packed_size(p)));
    dem_store_read(&store, sizeof h + (size_t)first*size*sizeof *packed, packed, count*size*sizeof *packed);
    DEM_TRY(verify(&store, path, q, &h, check(packed, count, size)));
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

static int take_row(struct dem_contacts *c, const struct head *h, const struct dem_recipe *r, const double *row, const int64_t *id,
                    size_t n)
{
    double memory[DEM_MEMORY_COLUMNS] = {0.0};
    struct dem_carried name;

    memcpy(&name, row, sizeof name);
    name.counted = (uint32_t)owned(id, n, name.low);
    for (int64_t k = 0; k < h->memories; k++)
    {
        for (int m = 0; m < r->memories; m++)
        {
            memory[m] = strcmp(r->memory[m], h->list[h->materials + h->columns + k].name) == 0 ? row[ROW_NAME + k] : memory[m];
        }
    }
    return name.counted || owned(id, n, name.high) ? dem_contacts_carry(c, &name, memory) : DEM_OK;
}

/* Every rank looks at all rows and takes those of its own particles. */
int dem_snapshot_read_rows(const char *path, const struct dem_recipe *r, const struct dem_particles *p, struct dem_contacts *c)
{
    struct dem_store store;
    struct head h;
    int64_t *id;
    double *row;

    DEM_TRY(open_file(&store, MPI_COMM_NULL, 0, path, &h));
    const size_t size = row_doubles(&h);

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

        dem_store_read(&store, rows_at(&h) + (size_t)at*size*sizeof *row, row, count*size*sizeof *row);
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
    struct head h;
    double *item;
    uint64_t sum = 0;

    DEM_TRY(open_file(&store, MPI_COMM_NULL, 0, path, &h));
    const size_t size = particle_doubles(&h), row = row_doubles(&h);

    DEM_TRY(DEM_NEW(item, size + row));
    *fingerprint = 0;
    for (size_t i = 0; i < (size_t)h.particles && !store.status; i++)
    {
        struct dem_particle record;

        dem_store_read(&store, sizeof h + i*size*sizeof *item, item, size*sizeof *item);
        memcpy(&record, item, sizeof record);
        sum += check(item, 1, size);
        *fingerprint += dem_fingerprint_particle(&record);
    }
    for (size_t k = 0; k < (size_t)h.rows && !store.status; k++)
    {
        struct dem_carried name;

        dem_store_read(&store, rows_at(&h) + k*row*sizeof *item, item, row*sizeof *item);
        memcpy(&name, item, sizeof name);
        sum += check(item, 1, row);
        *fingerprint += dem_fingerprint_row(&name, item + ROW_NAME, (int)h.memories);
    }
    dem_memory_free(item);
    DEM_TRY(dem_store_close(&store));
    return agrees(path, &h, sum);
}
