/*
 * contact_rows.h -- the candidate contacts of a rank: a row for each pair with gap < inner skin.
 *
 * Pruned from the pairs and tested in each step. A row is seen from the lower id (i) to the higher
 * id or the wall (j). Each class of pairs has a segment of rows, padded to whole batches. A particle
 * sums its rows in the order of `entry`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "contacts/pair_list.h"

enum                           /* bits of an entry, below the slot of the contact force of its row */
{
    DEM_ENTRY_SIDE = 1,        /* 1: of j */
    DEM_ENTRY_LAST = 2,        /* 1: the last one of its particle */
    DEM_ENTRY_SLOT_SHIFT = 3,  /* so that slot times the size of a contact force is 8 times the
                                  entry without bits */
    DEM_ENTRIES_AT_ONCE = 2    /* a particle has a multiple of this */
};

enum
{
    DEM_PADDING_ROWS = 8,    /* rows past the last, with zero force */
    DEM_STRETCH_ROWS = 256   /* rows swept together, whole batches, where few touch */
};

enum
{
    DEM_PARTNER_SHIFT = 27,                      /* bits of a record's index in
                                                    struct dem_row_partners */
    DEM_PARTNER_LIMIT = 1 << DEM_PARTNER_SHIFT,  /* limit of the records of a rank */
    DEM_RECORD_OF_J = DEM_PARTNER_LIMIT - 1,     /* mask: j without the shift */
    DEM_ROWS_AHEAD = 32                          /* rows prefetched ahead, also past the
                                                    last: 16 and 64 gained a little less */
};

/* partners of a row: the compact form of its pair */
struct dem_row_partners
{
    uint32_t i, j;                /* records; above the bits of j the shift */
};

/* the rows of one class, padded to whole batches */
struct dem_segment
{
    uint32_t first, count;
    uint32_t slot;                /* of the contact force of the first row (contact_forces.h); with a
                                     ring only of walls */
};

struct dem_contact_rows
{
    uint32_t n;                          /* with padding */
    uint32_t walls;                      /* the first row of a wall, or n: their classes are last */
    int few_touch;                       /* 1: less than half of the rows of pairs did at the last prune */
    size_t capacity;
    uint32_t *pair;                      /* DEM_ROW_NONE on padding */
    struct dem_row_partners *partners;   /* padding repeats the last row of its class;
                                            DEM_ROWS_AHEAD zeros past the end */
    struct dem_segment *segment;         /* one per class */
    int classes;
    size_t start_capacity, entry_capacity, needed_capacity;
    uint32_t *start, *entry;             /* of each owned particle: slot and bits, made up to a
                                            multiple of DEM_ENTRIES_AT_ONCE, and at least that, by
                                            entries without a row, whose force is zero */
    uint32_t *needed;                    /* per batch of owned particles: number of pair rows that
                                            must be computed (with all wall rows) before this batch
                                            and all before it can be summed */
};

int dem_contact_rows_init(struct dem_contact_rows *, int classes);
void dem_contact_rows_free(struct dem_contact_rows *);
size_t dem_contact_rows_bytes(const struct dem_contact_rows *);

/* Make a row of each pair marked in `near` (one byte per pair), then the adjacency of the owned
   particles, of this number; its slots are rows. *from: former index of each row, DEM_ROW_NONE for a
   new one; valid until dem_contact_rows_build_adjacency, which needs its memory. */
int dem_contact_rows_number(struct dem_contact_rows *, struct dem_pair_list *, const uint8_t *near,
                            size_t particles, const uint32_t **from);
int dem_contact_rows_build_adjacency(struct dem_contact_rows *, const struct dem_pair_list *,
                                     size_t particles);

/* Free the rows, not the adjacency. */
void dem_contact_rows_clear(struct dem_contact_rows *);
