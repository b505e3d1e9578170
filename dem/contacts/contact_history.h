/*
 * contact_history.h -- the history of contacts: columns of numbers per row; saved history by key.
 *
 * History survives a prune by the former index of the row, and a rebuild or a change of rank as
 * saved history with the key (lower id, higher id or facet, image). The key depends neither on lists
 * nor on ranks, so saved history also moves with particles between ranks and into snapshots. Rows
 * are matched with keys by hashing.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/interaction_table.h"

#include <stddef.h>
#include <stdint.h>

/* the facet of a wall neighbor in the keys of contacts */
struct dem_facet_key
{
    int number;
    uint32_t image;               /* as in a pair (periodic_image.h), along the axes where a
                                     particle may touch two images of the facet */
};

/* key of a contact whose history is saved */
struct dem_contact_key
{
    int64_t low, high;            /* ids; high is -1 - facet at a wall */
    uint32_t image;
    uint32_t counted;             /* 1: this rank counts the contact (after a load) */
};

struct dem_contact_history
{
    int columns;
    double *column[DEM_HISTORY_COLUMNS];  /* one value per row */
    double *scratch;                      /* one further column */
    size_t capacity;                      /* of each column */
    size_t saved, saved_capacity, saved_value_capacity;
    struct dem_contact_key *saved_key;
    double *saved_value;                  /* `columns` numbers per key */
};

void dem_contact_history_free(struct dem_contact_history *);
size_t dem_contact_history_bytes(const struct dem_contact_history *);

/* Columns for `capacity` rows. _move: row r gets what was at from[r], zero where that is
   DEM_ROW_NONE. */
int dem_contact_history_resize(struct dem_contact_history *, size_t capacity);
void dem_contact_history_move(struct dem_contact_history *, uint32_t rows, const uint32_t *from);
void dem_contact_history_clear(struct dem_contact_history *);    /* free the columns */

/* 1 when any value of the row is not zero; copy the values of a row to the array. */
int dem_contact_history_any(const struct dem_contact_history *, uint32_t row);
void dem_contact_history_get(const struct dem_contact_history *, uint32_t row, double *values);

/* Append one contact to the saved history; make room for `more` of them. */
int dem_contact_history_reserve(struct dem_contact_history *, size_t more);
int dem_contact_history_append(struct dem_contact_history *, const struct dem_contact_key *,
                               const double *values);

/* Saved contacts by key. The caller frees `slot`. */
struct dem_contact_hash
{
    uint32_t *slot;               /* 0: free, else index + 1 */
    size_t mask;                  /* number of slots - 1 */
};
int dem_contact_history_hash(const struct dem_contact_history *, struct dem_contact_hash *);

/* Give a row the saved history of this key, if there is one. */
void dem_contact_history_take(struct dem_contact_history *, const struct dem_contact_hash *,
                              const struct dem_contact_key *, uint32_t row);

/* Drop saved contacts of these n ids, which are in rising order. */
void dem_contact_history_drop(struct dem_contact_history *, const int64_t *id, size_t n);
void dem_contact_history_forget(struct dem_contact_history *);   /* free the saved history */
