/*
 * hash.c -- 64-bit hash: the words of the input are mixed into a state one after the other.
 *
 * One full mix per word takes about 4 ns. A cheaper step (multiplication only, as FNV does) moves
 * the bits of a word upward only, so that changes of two signs can cancel. Hashes are computed at
 * output times only, so the full mix is affordable.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/hash.h"

#include "core/random.h"

#include <string.h>

static uint64_t mix_word(uint64_t state, uint64_t word)
{
    return dem_random_mix(state ^ word);
}

void dem_hash_start(struct dem_hash *h, uint64_t salt)
{
    *h = (struct dem_hash){.state = dem_random_mix(salt)};
}

void dem_hash_bytes(struct dem_hash *h, const void *bytes, size_t n)
{
    const unsigned char *at = bytes;

    for (; n >= 8 && h->length%8 == 0; at += 8, n -= 8, h->length += 8)
    {
        uint64_t word;

        memcpy(&word, at, sizeof word);
        h->state = mix_word(h->state, word);
    }
    while (n > 0)
    {
        const size_t filled = h->length%8, used = n < 8 - filled ? n : 8 - filled;

        memcpy((unsigned char *)&h->word + filled, at, used);
        at += used;
        n -= used;
        h->length += used;
        if (filled + used == 8)
        {
            h->state = mix_word(h->state, h->word);
            h->word = 0;
        }
    }
}

uint64_t dem_hash_value(const struct dem_hash *h)
{
    const uint64_t state = h->length%8 > 0 ? mix_word(h->state, h->word) : h->state;

    return mix_word(state, h->length);
}

uint64_t dem_hash_record(const void *bytes, size_t n, uint64_t salt)
{
    struct dem_hash h;

    dem_hash_start(&h, salt);
    dem_hash_bytes(&h, bytes, n);
    return dem_hash_value(&h);
}
