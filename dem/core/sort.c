/*
 * sort.c -- radix sort from the lowest byte up, skipping the bytes that all keys share.
 *
 * 1. One pass over the keys counts the values of all bytes at once.
 * 2. One pass for each byte moves every element from one array to the other, keeping the order of
 *    equal bytes.
 * 3. After an odd number of passes the result is in the scratch array and is copied back.
 *
 * Source: Knuth, The Art of Computer Programming 3, 5.2.5.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/sort.h"

#include <string.h>

enum
{
    BYTES = 8,
    VALUES = 256
};

static unsigned byte_of(uint64_t key, int b)
{
    return (unsigned)(key >> 8*b) & 255u;
}

/* Turn the number of elements with each value of a byte into the index of the first of them. */
static void counts_to_offsets(size_t *count)
{
    size_t offset = 0;

    for (int v = 0; v < VALUES; v++)
    {
        const size_t n = count[v];

        count[v] = offset;
        offset += n;
    }
}

static void count_bytes(size_t count[BYTES][VALUES], uint64_t key)
{
    for (int b = 0; b < BYTES; b++)
    {
        count[b][byte_of(key, b)]++;
    }
}

void dem_sort_keys(uint64_t *key, uint32_t *index, size_t n, uint64_t *key_scratch,
                   uint32_t *index_scratch)
{
    size_t count[BYTES][VALUES] = {{0}};
    uint64_t *from = key, *to = key_scratch;
    uint32_t *from_index = index, *to_index = index_scratch;

    for (size_t i = 0; i < n; i++)
    {
        count_bytes(count, key[i]);
    }
    for (int b = 0; b < BYTES; b++)
    {
        if (n == 0 || count[b][byte_of(key[0], b)] == n)
        {
            continue;
        }
        counts_to_offsets(count[b]);
        for (size_t i = 0; i < n; i++)
        {
            const size_t at = count[b][byte_of(from[i], b)]++;

            to[at] = from[i];
            to_index[at] = from_index[i];
        }

        uint64_t *const keys = from;
        uint32_t *const indices = from_index;

        from = to;
        from_index = to_index;
        to = keys;
        to_index = indices;
    }
    if (from != key)
    {
        memcpy(key, from, n*sizeof *key);
        memcpy(index, from_index, n*sizeof *index);
    }
}

/* One pass over byte b of a pair: bytes 0-7 are in lo, 8-15 in hi. */
static void move_pairs(const struct dem_sort_pair *from, struct dem_sort_pair *to, size_t n,
                       size_t *offset, int b)
{
    for (size_t i = 0; i < n; i++)
    {
        to[offset[byte_of(b < BYTES ? from[i].lo : from[i].hi, b%BYTES)]++] = from[i];
    }
}

void dem_sort_pairs(struct dem_sort_pair *pair, size_t n, struct dem_sort_pair *scratch)
{
    size_t count[2*BYTES][VALUES] = {{0}};
    struct dem_sort_pair *from = pair, *to = scratch;

    for (size_t i = 0; i < n; i++)
    {
        count_bytes(count, pair[i].lo);
        count_bytes(count + BYTES, pair[i].hi);
    }
    for (int b = 0; b < 2*BYTES; b++)
    {
        if (n == 0 || count[b][byte_of(b < BYTES ? pair[0].lo : pair[0].hi, b%BYTES)] == n)
        {
            continue;
        }
        counts_to_offsets(count[b]);
        move_pairs(from, to, n, count[b], b);

        struct dem_sort_pair *const pairs = from;

        from = to;
        to = pairs;
    }
    if (from != pair)
    {
        memcpy(pair, from, n*sizeof *pair);
    }
}
