/*
 * snapshot_head.c -- sizes, places and checksums that writing and reading share.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/snapshot_head.h"
#include "io/hash.h"

const char dem_snapshot_magic[8] = "SUNADEM";
const uint64_t dem_snapshot_order = 0x0102030405060708u;

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
