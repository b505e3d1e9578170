/*
 * test_hash.c -- the hash depends on every bit and on the order within a record, not on how the
 * bytes are divided; sums of hashes do not depend on the order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tap.h"

#include "core/random.h"
#include "core/hash.h"

#include <stdlib.h>
#include <string.h>

static uint64_t hash(const void *bytes, size_t n, uint64_t salt)
{
    return dem_hash_record(bytes, n, salt);
}

/* Values from a second implementation in another language, written from the description in
   hash.h. */
static void known_values(void)
{
    unsigned char count[64];

    for (int i = 0; i < 64; i++)
    {
        count[i] = (unsigned char)i;
    }
    TAP_OK(hash("", 0, 0) == 0xa706dd2f4d197e6fu, "nothing");
    TAP_OK(hash("", 0, 1) == 0x5e41ab087439611eu, "nothing with a salt");
    TAP_OK(hash("sand", 4, 0) == 0x5de3da0ecf45b80du, "less than a word");
    TAP_OK(hash("a grain of sand", 15, 7) == 0x789d381e7585abd7u, "a word and a remainder");
    TAP_OK(hash(count, 64, 3) == 0x38719fd3f3e9869bu, "eight words");
}

static void cuts(void)
{
    unsigned char bytes[100];
    int same = 0;

    for (size_t i = 0; i < sizeof bytes; i++)
    {
        bytes[i] = (unsigned char)dem_random_bits(5, i, 0, 0);
    }
    for (size_t a = 0; a <= sizeof bytes; a++)
    {
        const size_t b = a + (sizeof bytes - a)/3;
        struct dem_hash h;

        dem_hash_start(&h, 9);
        dem_hash_bytes(&h, bytes, a);
        dem_hash_bytes(&h, bytes + a, b - a);
        (void)dem_hash_value(&h);
        dem_hash_bytes(&h, bytes + b, sizeof bytes - b);
        same += dem_hash_value(&h) == hash(bytes, sizeof bytes, 9);
    }
    TAP_OK(same == 101, "divided at %d of 101 positions the hash is the same", same);
}

/* One bit of 64 bytes changes half the bits of the hash: mean 32, and over 512 x 20 trials its
   error is 4/sqrt(10240). */
static void every_bit(void)
{
    unsigned char bytes[64];
    int changed = 0, least = 64;

    for (uint64_t trial = 0; trial < 20; trial++)
    {
        for (size_t i = 0; i < sizeof bytes; i++)
        {
            bytes[i] = (unsigned char)dem_random_bits(6, i, trial, 0);
        }
        const uint64_t before = hash(bytes, sizeof bytes, 0);

        for (size_t bit = 0; bit < 512; bit++)
        {
            bytes[bit/8] ^= (unsigned char)(1 << bit%8);
            const int n = __builtin_popcountll(before ^ hash(bytes, sizeof bytes, 0));
            bytes[bit/8] ^= (unsigned char)(1 << bit%8);
            changed += n;
            least = n < least ? n : least;
        }
    }
    TAP_NEAR(changed/10240.0, 32.0, 5*4/sqrt(10240.0),
             "a flipped bit changes half the hash (within 5 sigma)");
    TAP_OK(least >= 8, "and never less than 8 of 64 bits (chance 1e-6 in all trials): %d", least);
}

static int compare(const void *a, const void *b)
{
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;

    return (x > y) - (x < y);
}

/* Records similar to particles: consecutive ids, signs, zeros. By chance two of 80000 agree once in
   6e9 such sets. */
static void near_records(void)
{
    enum { N = 80000 };
    uint64_t *all = malloc(N*sizeof *all);
    int equal = 0;

    for (int64_t i = 0; i < N; i++)
    {
        struct
        {
            int64_t id;
            double x[3];
        } r = {i/8, {i & 1 ? -1.0 : 1.0, i & 2 ? -0.0 : 0.0, i & 4 ? -1.0 : 1.0}};

        all[i] = hash(&r, sizeof r, 'p');
    }
    qsort(all, N, sizeof *all, compare);
    for (int i = 1; i < N; i++)
    {
        equal += all[i] == all[i - 1];
    }
    free(all);
    TAP_OK(equal == 0, "%d equal hashes among %d records that differ in id and signs", equal, N);
}

static void sums(void)
{
    struct { int64_t id; double x; } r[1000], s[1000];
    uint64_t forward = 0, backward = 0, parts[7] = {0}, together = 0, swapped = 0;

    for (int i = 0; i < 1000; i++)
    {
        r[i].id = i;
        r[i].x = dem_random_unit(7, (uint64_t)i, 0, 0);
        forward += hash(&r[i], sizeof *r, 1);
        parts[i%7] += hash(&r[i], sizeof *r, 1);
    }
    memcpy(s, r, sizeof r);
    s[3].x = r[4].x;
    s[4].x = r[3].x;
    for (int i = 999; i >= 0; i--)
    {
        backward += hash(&r[i], sizeof *r, 1);
        swapped += hash(&s[i], sizeof *s, 1);
    }
    for (int i = 0; i < 7; i++)
    {
        together += parts[i];
    }
    TAP_OK(forward == backward, "the sum does not depend on the order");
    TAP_OK(forward == together, "the sum does not depend on partial sums");
    TAP_OK(forward != swapped, "the sum detects two swapped particles");
    TAP_OK(hash("ab", 2, 0) != hash("ba", 2, 0) && hash("a", 1, 0) != hash("a\0", 2, 0),
           "the hash depends on order and length within a record");
    TAP_OK(hash(r, 16, 1) != hash(r, 16, 2), "the hash depends on the salt");
}

int main(void)
{
    TAP_TRAPS;
    known_values();
    cuts();
    every_bit();
    near_records();
    sums();
    TAP_DONE;
}
