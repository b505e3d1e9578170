/*
 * snapshot_head.c -- sizes, places and checksums that writing and reading share, and the look at a file that is opened.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/snapshot_head.h"
#include "base/error.h"
#include "io/hash.h"
#include "io/snapshot_judge.h"
#include <string.h>

const char dem_snapshot_magic[8] = "SUNADEM";
const uint64_t dem_snapshot_order = 0x0102030405060708u;

static const int64_t most_width = 16;                     /* of a column: the widest has 4 numbers */

size_t dem_snapshot_particle_doubles(const struct dem_snapshot_head *h)
{
    size_t size = DEM_SNAPSHOT_RECORD;

    for (int64_t c = 0; c < h->columns; c++)
    {
        size += (size_t)h->list[h->materials + c].width;
    }
    return size;
}

size_t dem_snapshot_row_doubles(const struct dem_snapshot_head *h)
{
    return DEM_SNAPSHOT_ROW + (size_t)h->memories;
}

size_t dem_snapshot_rows_at(const struct dem_snapshot_head *h)
{
    return sizeof *h + (size_t)h->particles*dem_snapshot_particle_doubles(h)*sizeof(double);
}

size_t dem_snapshot_beside_at(const struct dem_snapshot_head *h)
{
    return dem_snapshot_rows_at(h) + (size_t)h->rows*dem_snapshot_row_doubles(h)*sizeof(double);
}

void dem_snapshot_share(const struct dem_pieces *q, int64_t n, int64_t *first, int64_t *count)
{
    *first = n*q->rank/q->ranks;
    *count = n*(q->rank + 1)/q->ranks - *first;
}

uint64_t dem_snapshot_head_check(const struct dem_snapshot_head *h)
{
    struct dem_snapshot_head plain = *h;

    plain.head_checksum = 0;
    return dem_hash_record(&plain, sizeof plain, 'h');
}

uint64_t dem_snapshot_check(const double *data, size_t count, size_t size)
{
    uint64_t sum = 0;

    for (size_t k = 0; k < count; k++)
    {
        sum += dem_hash_record(data + k*size, size*sizeof *data, size);
    }
    return sum;
}

int dem_snapshot_is_name(const char *name, size_t room)
{
    size_t k = 0;

    while (k < room && (unsigned char)name[k] >= ' ' && name[k] != 127)
    {
        k++;
    }
    return k < room && name[k] == '\0';
}

/* ---- opening --------------------------------------------------------------------------------------------------- */

/* Are the counts such that the file's places can be told from them, and names are names? A checksum guards against damage only. */
static int counts_well(const struct dem_snapshot_head *h, size_t found)
{
    int well = h->materials >= 0 && h->materials <= DEM_MATERIALS && h->columns >= 0 && h->columns <= DEM_COLUMNS
        && h->memories >= 0 && h->memories <= DEM_MEMORY_COLUMNS && h->flows >= 0 && h->flows <= DEM_SNAPSHOT_FLOWS;

    for (int64_t k = 0; well && k < h->materials + h->columns + h->memories; k++)
    {
        well = h->list[k].width >= 0 && h->list[k].width <= most_width && dem_snapshot_is_name(h->list[k].name, sizeof h->list[k].name);
    }
    for (int64_t k = 0; well && k < h->flows; k++)
    {
        well = dem_snapshot_is_name(h->flow[k].name, sizeof h->flow[k].name);
    }
    return well && h->particles >= 0 && (size_t)h->particles <= found/(dem_snapshot_particle_doubles(h)*sizeof(double))
        && h->rows >= 0 && (size_t)h->rows <= found/(dem_snapshot_row_doubles(h)*sizeof(double)) && h->beside >= 0;
}

static int read_head(struct dem_store *s, struct dem_snapshot_head *h)
{
    memset(h->magic, 0, sizeof h->magic);
    dem_store_read(s, 0, h->magic, sizeof h->magic);      /* alone: a file of another kind may be shorter than a head */
    DEM_REQUIRE(memcmp(h->magic, dem_snapshot_magic, sizeof h->magic) == 0, DEM_ERROR_FILE, "%s is not a snapshot of Suna", s->path);
    dem_store_read(s, 0, h, sizeof *h);
    DEM_TRY(s->status);
    DEM_REQUIRE(h->order == dem_snapshot_order, DEM_ERROR_FILE,
                "%s was written on a machine of another byte order, or is damaged", s->path);
    DEM_REQUIRE(h->version == DEM_SNAPSHOT_VERSION, DEM_ERROR_FILE,
                "%s is of version %llu, this program reads version %d; write it anew", s->path, (unsigned long long)h->version,
                DEM_SNAPSHOT_VERSION);
    const uint64_t sum = dem_snapshot_head_check(h);

    DEM_REQUIRE(sum == h->head_checksum, DEM_ERROR_FILE,
                "%s is damaged: its head has checksum %016llx and should have %016llx; use another one", s->path,
                (unsigned long long)sum, (unsigned long long)h->head_checksum);
    const size_t found = dem_store_size(s);

    DEM_REQUIRE(counts_well(h, found), DEM_ERROR_FILE, "%s is damaged: its head tells of %lld particles, %lld rows, %lld materials, %lld columns and "
                "%lld numbers remembered, which its %zu bytes can't hold, or of names that are none; use another one", s->path,
                (long long)h->particles, (long long)h->rows, (long long)h->materials, (long long)h->columns, (long long)h->memories, found);
    DEM_TRY(dem_snapshot_judge_head(s->path, h));
    const size_t size = dem_snapshot_beside_at(h) + (size_t)h->beside;

    DEM_REQUIRE(found == size, DEM_ERROR_FILE, "%s is damaged: it has %zu bytes and should have %zu; use another one", s->path, found,
                size);
    return DEM_OK;
}

int dem_snapshot_open(struct dem_store *s, const struct dem_writers *by, const char *path, struct dem_snapshot_head *h)
{
    DEM_TRY(dem_store_open(s, by, path));
    int status = by->rank == 0 ? read_head(s, h) : DEM_OK;

    if (by->comm != MPI_COMM_NULL)
    {
        MPI_Bcast(&status, 1, MPI_INT, 0, by->comm);
        MPI_Bcast(h, (int)sizeof *h, MPI_BYTE, 0, by->comm);
    }
    if (status)
    {
        status = by->rank == 0 ? status : dem_error(status, "another rank failed; its message tells why");
        s->status = status;                               /* the sentence that counts has been said */
        (void)dem_store_close(s);
    }
    return status;
}
