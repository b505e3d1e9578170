/*
 * snapshot_header.h -- the header of a snapshot file and the offsets of its parts.
 *
 * The file holds the header, the particles, the contacts with history, then the data of the caller,
 * in 8-byte words. struct dem_snapshot_header is stored raw: its members keep their order and sizes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "records/snapshot.h"
#include "ranks/parallel_file.h"
#include "contacts/contacts.h"
#include "particles/particles.h"
#include "laws/interaction_table.h"
#include <stddef.h>
#include <stdint.h>

enum
{
    DEM_SNAPSHOT_VERSION = 8,
    DEM_SNAPSHOT_NAME = 48,
    DEM_SNAPSHOT_NAMES = 128,    /* fixed, so that a new column does not change the layout */
    DEM_SNAPSHOT_RECORD = (int)(sizeof(struct dem_particle)/sizeof(double)),
    DEM_SNAPSHOT_CONTACT = (int)(sizeof(struct dem_contact_key)/sizeof(double))
};
_Static_assert(DEM_MATERIALS + DEM_COLUMNS + DEM_FURTHER_COLUMNS + DEM_HISTORY_COLUMNS <= DEM_SNAPSHOT_NAMES,
               "the header has a slot for every name");

struct dem_snapshot_header
{
    char magic[8];
    uint64_t order, version;
    /* of particles and contacts; of the caller's data; of the header without it */
    uint64_t checksum, caller_data_checksum, head_checksum;
    /* beside: bytes of the caller's data */
    int64_t particles, rows, steps, caller_data;
    double time;
    struct dem_snapshot_window window;
    int64_t skin_tuning[DEM_SNAPSHOT_SKIN_TUNING];
    int64_t flows, next_id;
    struct dem_snapshot_flow flow[DEM_SNAPSHOT_FLOWS];
    int64_t materials, columns, memories;
    struct
    {
        char name[DEM_SNAPSHOT_NAME];
        int64_t width;
    /* materials, then columns, then history */
    } list[DEM_SNAPSHOT_NAMES];
};

/* The eight characters at the beginning of a snapshot, and a number that shows the byte order. */
extern const char dem_snapshot_magic[8];
extern const uint64_t dem_snapshot_order;

/* Number of doubles of a particle and of a contact; offsets [byte] of the contacts and of the
   caller's data. */
size_t dem_snapshot_particle_doubles(const struct dem_snapshot_header *);
size_t dem_snapshot_contact_doubles(const struct dem_snapshot_header *);
size_t dem_snapshot_contacts_offset(const struct dem_snapshot_header *);
size_t dem_snapshot_caller_data_offset(const struct dem_snapshot_header *);

/* 1 when these `size` bytes hold a printable name: terminated and without control characters. */
int dem_snapshot_is_name(const char *name, size_t size);

/* Collective. Open a file, read its header and check that it is a snapshot, undamaged and
   complete. The first rank checks and broadcasts the result. */
int dem_snapshot_open(struct dem_parallel_file *, const struct dem_file_ranks *, const char *path,
                      struct dem_snapshot_header *);

/* The slice of n items that this rank reads: first index and count. */
void dem_snapshot_slice(const struct dem_decomposition *, int64_t n, int64_t *first,
                        int64_t *count);

/* Checksums: of the header without its own checksum, and of `count` items of `size` doubles,
   which does not depend on the order of the items. */
uint64_t dem_snapshot_header_checksum(const struct dem_snapshot_header *);
uint64_t dem_snapshot_checksum(const double *data, size_t count, size_t size);
