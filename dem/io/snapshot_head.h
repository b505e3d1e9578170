/*
 * snapshot_head.h -- how a snapshot lies in its file: the head, then particles, then remembered contacts, in 8-byte words.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_SNAPSHOT_HEAD_H
#define DEM_IO_SNAPSHOT_HEAD_H

#include "state/contacts.h"
#include "state/particles.h"
#include "state/recipe.h"
#include <stddef.h>
#include <stdint.h>

enum
{
    DEM_SNAPSHOT_VERSION = 2,
    DEM_SNAPSHOT_NAME = 48,
    DEM_SNAPSHOT_NAMES = 128,                             /* a fixed number, so that a new column moves nothing in the file */
    DEM_SNAPSHOT_RECORD = (int)(sizeof(struct dem_particle)/sizeof(double)),
    DEM_SNAPSHOT_ROW = (int)(sizeof(struct dem_carried)/sizeof(double))
};
_Static_assert(DEM_MATERIALS + DEM_COLUMNS + DEM_MEMORY_COLUMNS <= DEM_SNAPSHOT_NAMES, "the head has room for all names");

struct dem_snapshot_head
{
    char magic[8];
    uint64_t order, version, checksum, head_checksum;     /* of particles and rows; of this head without itself */
    int64_t particles, rows, steps;
    double time;
    int64_t materials, columns, memories;
    struct
    {
        char name[DEM_SNAPSHOT_NAME];
        int64_t width;
    } list[DEM_SNAPSHOT_NAMES];                           /* materials, columns, memory */
};

/* The eight letters that a snapshot starts with, and a number that tells the order of bytes. */
extern const char dem_snapshot_magic[8];
extern const uint64_t dem_snapshot_order;

/* Doubles of a particle and of a remembered row; the byte at which rows begin. */
size_t dem_snapshot_particle_doubles(const struct dem_snapshot_head *);
size_t dem_snapshot_row_doubles(const struct dem_snapshot_head *);
size_t dem_snapshot_rows_at(const struct dem_snapshot_head *);

/* Checksums: of the head without its own, and of `count` items of `size` doubles, whose sum forgets the order. */
uint64_t dem_snapshot_head_check(const struct dem_snapshot_head *);
uint64_t dem_snapshot_check(const double *data, size_t count, size_t size);

#endif
