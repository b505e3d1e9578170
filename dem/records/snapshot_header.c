/*
 * snapshot_header.c -- checksums of a snapshot; open a file and check its header.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/snapshot_header.h"
#include "core/error.h"
#include "core/hash.h"
#include "ranks/mpi_error.h"
#include "records/snapshot_validate.h"
#include <string.h>

const char dem_snapshot_magic[8] = "SUNADEM";
const uint64_t dem_snapshot_order = 0x0102030405060708u;

static const int64_t max_width = 24;    /* of a column; the widest has 20 numbers */

void dem_snapshot_slice(const struct dem_decomposition *q, int64_t n, int64_t *first,
                        int64_t *count)
{
    *first = n*q->rank/q->ranks;
    *count = n*(q->rank + 1)/q->ranks - *first;
}

uint64_t dem_snapshot_header_checksum(const struct dem_snapshot_header *h)
{
    struct dem_snapshot_header copy = *h;

    copy.head_checksum = 0;
    return dem_hash_record(&copy, sizeof copy, 'h');
}

uint64_t dem_snapshot_checksum(const double *data, size_t count, size_t size)
{
    uint64_t sum = 0;

    for (size_t k = 0; k < count; k++)
    {
        sum += dem_hash_record(data + k*size, size*sizeof *data, size);
    }
    return sum;
}

int dem_snapshot_is_name(const char *name, size_t size)
{
    size_t k = 0;

    while (k < size && (unsigned char)name[k] >= ' ' && name[k] != 127)
    {
        k++;
    }
    return k < size && name[k] == '\0';
}

/* ---- opening --------------------------------------------------------------------------------- */

/* Are the counts and names valid, so that offsets can be computed from them? A correct checksum
   excludes damage only. */
static int is_consistent(const struct dem_snapshot_header *h, size_t found)
{
    int good = h->materials >= 0 && h->materials <= DEM_MATERIALS && h->columns >= 0 &&
               h->columns <= DEM_COLUMNS + DEM_FURTHER_COLUMNS && h->memories >= 0 &&
               h->memories <= DEM_HISTORY_COLUMNS && h->flows >= 0 &&
               h->flows <= DEM_SNAPSHOT_FLOWS;

    for (int64_t k = 0; good && k < h->materials + h->columns + h->memories; k++)
    {
        good = h->list[k].width >= 0 && h->list[k].width <= max_width &&
               dem_snapshot_is_name(h->list[k].name, sizeof h->list[k].name);
    }
    for (int64_t k = 0; good && k < h->flows; k++)
    {
        good = dem_snapshot_is_name(h->flow[k].name, sizeof h->flow[k].name);
    }
    return good && h->particles >= 0 &&
           (size_t)h->particles <= found/(dem_snapshot_particle_doubles(h)*sizeof(double)) &&
           h->rows >= 0 &&
           (size_t)h->rows <= found/(dem_snapshot_contact_doubles(h)*sizeof(double)) &&
           h->caller_data >= 0;
}

static int read_header(struct dem_parallel_file *s, struct dem_snapshot_header *h)
{
    memset(h->magic, 0, sizeof h->magic);
    /* first: a file of another kind may be shorter than a header */
    dem_parallel_file_read(s, 0, h->magic, sizeof h->magic);
    DEM_REQUIRE(memcmp(h->magic, dem_snapshot_magic, sizeof h->magic) == 0, DEM_ERROR_FILE,
                "%s is not a snapshot of Suna", s->path);
    dem_parallel_file_read(s, 0, h, sizeof *h);
    DEM_TRY(s->status);
    DEM_REQUIRE(h->order == dem_snapshot_order, DEM_ERROR_FILE,
                "%s was written on a machine of another byte order, or is damaged", s->path);
    DEM_REQUIRE(h->version == DEM_SNAPSHOT_VERSION, DEM_ERROR_FILE,
                "%s is of version %llu, this program reads version %d; write it again with this "
                "program", s->path, (unsigned long long)h->version, DEM_SNAPSHOT_VERSION);
    const uint64_t sum = dem_snapshot_header_checksum(h);

    DEM_REQUIRE(
        sum == h->head_checksum, DEM_ERROR_FILE,
        "%s is damaged: its header has checksum %016llx and should have %016llx; use another one",
        s->path, (unsigned long long)sum, (unsigned long long)h->head_checksum);
    const size_t found = dem_parallel_file_size(s);

    DEM_REQUIRE(
        is_consistent(h, found), DEM_ERROR_FILE,
        "%s is damaged: its header gives %lld particles, "
        "%lld contacts, %lld materials, %lld columns and %lld history columns, which do not fit into its %zu bytes, "
        "or has invalid names; use another one",
        s->path, (long long)h->particles, (long long)h->rows, (long long)h->materials,
        (long long)h->columns, (long long)h->memories, found);
    DEM_TRY(dem_snapshot_validate_header(s->path, h));
    const size_t size = dem_snapshot_caller_data_offset(h) + (size_t)h->caller_data;

    DEM_REQUIRE(found == size, DEM_ERROR_FILE,
                "%s is damaged: it has %zu bytes and should have %zu; use another one", s->path,
                found, size);
    return DEM_OK;
}

int dem_snapshot_open(struct dem_parallel_file *s, const struct dem_file_ranks *by,
                      const char *path, struct dem_snapshot_header *h)
{
    int mpi = DEM_OK;

    memset(h, 0, sizeof *h);
    DEM_TRY(dem_parallel_file_open(s, by, path));
    int status = by->rank == 0 ? read_header(s, h) : DEM_OK;

    if (by->comm != MPI_COMM_NULL)
    {
        mpi = DEM_MPI_STATUS(MPI_Bcast(&status, 1, MPI_INT, 0, by->comm));
        mpi = mpi ? mpi : DEM_MPI_STATUS(MPI_Bcast(h, (int)sizeof *h, MPI_BYTE, 0, by->comm));
    }
    if (status || mpi)
    {
        status = mpi ? mpi
                 : by->rank == 0 ? status
                                 : dem_error(status, "another rank failed; see its message");
        s->status = status;    /* keep the message of the rank that failed */
        (void)dem_parallel_file_close(s);
    }
    return status;
}
