/*
 * name_index.h -- finds a name among many in constant time: a hash table from names to numbers.
 *
 * Names are not copied. The caller compares them, since two may have one hash:
 *
 *     const uint64_t hash = dem_name_hash(name, strlen(name), 0);
 *     size_t at = 0, k;
 *
 *     while (dem_name_index_next(&x, hash, &at, &k) && strcmp(wall[k].name, name) != 0) { }
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct dem_name_index    /* empty when zero */
{
    struct dem_name_slot *slot;
    size_t slots, used;  /* slots: a power of two */
};

/* The salt separates names of different owners. */
uint64_t dem_name_hash(const char *name, size_t length, uint64_t salt);

int dem_name_index_add(struct dem_name_index *, uint64_t hash, size_t value);

/* The next value of this hash; *at is 0 for the first. False: there is none. */
bool dem_name_index_next(const struct dem_name_index *, uint64_t hash, size_t *at, size_t *value);

void dem_name_index_free(struct dem_name_index *);
