/*
 * test_sort.c -- the radix sorts order keys of every kind as a comparison sort, and keep equal keys
 * in their order (stable).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tap.h"

#include "core/random.h"
#include "core/sort.h"

#include <stdlib.h>
#include <string.h>

enum
{
    MAX_COUNT = 50000
};

static uint64_t key[MAX_COUNT], key_scratch[MAX_COUNT];
static uint32_t index_of[MAX_COUNT], index_scratch[MAX_COUNT];
static struct dem_sort_pair pair[MAX_COUNT], pair_scratch[MAX_COUNT], expected[MAX_COUNT];

/* by key, then by the former index: the result of a stable sort */
static int by_pair(const void *of_a, const void *of_b)
{
    const struct dem_sort_pair *a = of_a, *b = of_b;

    return a->hi != b->hi ? (a->hi > b->hi) - (a->hi < b->hi)
           : a->lo != b->lo ? (a->lo > b->lo) - (a->lo < b->lo)
                            : (a->index > b->index) - (a->index < b->index);
}

static int same(const struct dem_sort_pair *a, const struct dem_sort_pair *b, int n)
{
    for (int i = 0; i < n; i++)
    {
        if (a[i].hi != b[i].hi || a[i].lo != b[i].lo || a[i].index != b[i].index)
        {
            return 0;
        }
    }
    return 1;
}

/* keys with the bits of `rest` outside the mask */
static void check(const char *what, int n, uint64_t mask_hi, uint64_t mask_lo, uint64_t rest)
{
    for (int i = 0; i < n; i++)
    {
        pair[i].hi = (dem_random_bits(1, (uint64_t)i, 0, mask_lo) & mask_hi) | (rest & ~mask_hi);
        pair[i].lo = (dem_random_bits(2, (uint64_t)i, 0, mask_hi) & mask_lo) | (rest & ~mask_lo);
        pair[i].index = (uint32_t)i;
        key[i] = pair[i].lo;
        index_of[i] = (uint32_t)i;
    }
    memcpy(expected, pair, sizeof expected);
    qsort(expected, (size_t)n, sizeof *expected, by_pair);
    dem_sort_pairs(pair, (size_t)n, pair_scratch);
    TAP_OK(same(pair, expected, n), "pairs of %s, %d of them", what, n);

    for (int i = 0; i < n; i++)
    {
        expected[i] = (struct dem_sort_pair){0, key[i], (uint32_t)i};
    }
    qsort(expected, (size_t)n, sizeof *expected, by_pair);
    dem_sort_keys(key, index_of, (size_t)n, key_scratch, index_scratch);
    for (int i = 0; i < n; i++)
    {
        pair[i] = (struct dem_sort_pair){0, key[i], index_of[i]};
    }
    TAP_OK(same(pair, expected, n), "keys of %s, %d of them", what, n);
}

int main(void)
{
    TAP_TRAPS;
    check("all bits", MAX_COUNT, UINT64_MAX, UINT64_MAX, 0);
    check("one byte, so one pass and many equal keys", MAX_COUNT, 0, 0xff, 0);
    check("two separate bytes and constant ones between", MAX_COUNT, 0xff00, 0xff000000ff,
          0x1234567890abcdef);
    check("the highest bit alone", MAX_COUNT, UINT64_C(1) << 63, UINT64_C(1) << 63, 0);
    check("three bytes, an odd number of passes", MAX_COUNT, 0, 0xffffff, 0xabcdef0000000000);
    check("equal keys only", MAX_COUNT, 0, 0, 42);
    check("all bits", 2, UINT64_MAX, UINT64_MAX, 0);
    check("all bits", 1, UINT64_MAX, UINT64_MAX, 0);

    key[0] = 5;
    pair[0].lo = 5;
    dem_sort_keys(key, index_of, 0, key_scratch, index_scratch);
    dem_sort_pairs(pair, 0, pair_scratch);
    TAP_OK(key[0] == 5 && pair[0].lo == 5, "sorting no elements changes nothing");
    TAP_DONE;
}
