/*
 * sort.h -- stable sorting by integer keys in linear time; the order depends on the keys and nothing else.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Radix sort from the lowest byte up; a byte that all keys share costs one look and no pass. The caller
 * owns the scratch arrays (n elements each); nothing is allocated and nothing can fail.
 */
#ifndef DEM_BASE_SORT_H
#define DEM_BASE_SORT_H

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

/* A two-word key, hi before lo (a cell key and a particle id, say), and the place it came from. */
struct dem_sort_pair
{
    uint64_t hi, lo;
    uint32_t index;
};

/* qsort, but that there need be no list where nothing is in it. */
static inline void dem_sort_by(void *list, size_t n, size_t size, int (*compare)(const void *, const void *))
{
    if (n > 1)
    {
        qsort(list, n, size, compare);
    }
}

/* Sort key upwards, carrying index along; equal keys keep their order. */
void dem_sort_keys(uint64_t *key, uint32_t *index, size_t n, uint64_t *key_scratch, uint32_t *index_scratch);

/* Sort pairs upwards by (hi, lo); equal pairs keep their order. */
void dem_sort_pairs(struct dem_sort_pair *pair, size_t n, struct dem_sort_pair *scratch);

#endif
