/*
 * sort.h -- stable radix sort by integer keys in linear time; the order depends on the keys only.
 *
 * A byte that all keys share needs no pass. The caller owns the scratch arrays (n elements each);
 * nothing is allocated and nothing can fail.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

/* A two-word key, hi before lo (for example a cell key and a particle id), and the original
   index. */
struct dem_sort_pair
{
    uint64_t hi, lo;
    uint32_t index;
};

/* qsort that accepts a null list when n is 0. */
static inline void dem_sort_by(void *list, size_t n, size_t size,
                               int (*compare)(const void *, const void *))
{
    if (n > 1)
    {
        qsort(list, n, size, compare);
    }
}

/* Sort key in ascending order and permute index with it; equal keys keep their order. */
void dem_sort_keys(uint64_t *key, uint32_t *index, size_t n, uint64_t *key_scratch,
                   uint32_t *index_scratch);

/* Sort pairs in ascending order of (hi, lo); equal pairs keep their order. */
void dem_sort_pairs(struct dem_sort_pair *pair, size_t n, struct dem_sort_pair *scratch);
