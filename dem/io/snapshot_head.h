/*
 * snapshot_head.h -- how a snapshot lies in its file: the head, then particles, then remembered contacts, then bytes of
 * the caller's own, in 8-byte words.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_SNAPSHOT_HEAD_H
#define DEM_IO_SNAPSHOT_HEAD_H

#include "io/snapshot.h"
#include "io/store.h"
#include "state/contacts.h"
#include "state/particles.h"
#include "state/recipe.h"
#include <stddef.h>
#include <stdint.h>

enum
{
    DEM_SNAPSHOT_VERSION = 5,
    DEM_SNAPSHOT_NAME = 48,
    DEM_SNAPSHOT_NAMES = 128,                             /* a fixed number, so that a new column moves nothing in the file */
    DEM_SNAPSHOT_RECORD = (int)(sizeof(struct dem_particle)/sizeof(double)),
    DEM_SNAPSHOT_ROW = (int)(sizeof(struct dem_carried)/sizeof(double))
};
_Static_assert(DEM_MATERIALS + DEM_COLUMNS + DEM_MEMORY_COLUMNS <= DEM_SNAPSHOT_NAMES, "the head has room for all names");

struct dem_snapshot_head
{
    char magic[8];
    uint64_t order, version;
    uint64_t checksum, beside_checksum, head_checksum;    /* of particles and rows; of the caller's; of this head without itself */
    int64_t particles, rows, steps, beside;               /* beside: bytes */
    double time;
    struct dem_snapshot_window window;
    int64_t learnt[DEM_SNAPSHOT_LEARNT];
    int64_t flows, next_id;
    struct dem_snapshot_flow flow[DEM_SNAPSHOT_FLOWS];
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

/* Doubles of a particle and of a remembered row; the bytes at which rows begin, and what is the caller's. */
size_t dem_snapshot_particle_doubles(const struct dem_snapshot_head *);
size_t dem_snapshot_row_doubles(const struct dem_snapshot_head *);
size_t dem_snapshot_rows_at(const struct dem_snapshot_head *);
size_t dem_snapshot_beside_at(const struct dem_snapshot_head *);

/* 1 when these bytes hold a name that a sentence can tell: with an end, and no control characters. */
int dem_snapshot_is_name(const char *name, size_t room);

/* Open a file, read its head and check that it is one of ours, undamaged and whole. Collective: the first rank looks, all hear. */
int dem_snapshot_open(struct dem_store *, const struct dem_writers *, const char *path, struct dem_snapshot_head *);

/* The n items of a file that are this rank's to read: first and how many. */
void dem_snapshot_share(const struct dem_pieces *, int64_t n, int64_t *first, int64_t *count);

/* Checksums: of the head without its own, and of `count` items of `size` doubles, whose sum forgets the order. */
uint64_t dem_snapshot_head_check(const struct dem_snapshot_head *);
uint64_t dem_snapshot_check(const double *data, size_t count, size_t size);

#endif
