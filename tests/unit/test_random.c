/*
 * test_random.c -- random numbers are functions of (seed, id, step, use), uniform in [0, 1), and
 * independent of their neighbors in each of the four words.
 *
 * The numbers are always the same, so a test always passes or always fails; limits are five
 * standard deviations of true randomness (exceeded by chance once in two million).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tap.h"

#include "core/random.h"

#include <stdlib.h>

enum
{
    DRAWS = 1 << 18,
    WORDS = 4,
    CELLS = 256
};

static const char *const word_name[WORDS] = {"seed", "id", "step", "use"};

/* the i-th draw when one of the words is counted up */
static uint64_t bits_along(int word, uint64_t i)
{
    uint64_t w[WORDS] = {12, 34, 56, 78};

    w[word] = i;
    return dem_random_bits(w[0], w[1], w[2], w[3]);
}

static double unit_along(int word, uint64_t i)
{
    uint64_t w[WORDS] = {12, 34, 56, 78};

    w[word] = i;
    return dem_random_unit(w[0], w[1], w[2], w[3]);
}

/* mean 1/2, variance 1/12, and no correlation with the next one */
static void moments(int word)
{
    double sum = 0.0, square = 0.0, product = 0.0, last = unit_along(word, DRAWS) - 0.5;
    int inside = 1;

    for (uint64_t i = 0; i < DRAWS; i++)
    {
        const double u = unit_along(word, i) - 0.5;

        inside &= u >= -0.5 && u < 0.5;
        sum += u;
        square += u*u;
        product += u*last;
        last = u;
    }
    /* standard deviations of one term: 1/sqrt(12), sqrt(1/180), 1/12 */
    TAP_OK(inside, "along %s: all in [0, 1)", word_name[word]);
    TAP_NEAR(sum/DRAWS, 0.0, 5.0*sqrt(1.0/12.0/DRAWS), "along %s: mean", word_name[word]);
    TAP_NEAR(square/DRAWS, 1.0/12.0, 5.0*sqrt(1.0/180.0/DRAWS), "along %s: variance",
             word_name[word]);
    TAP_NEAR(product/DRAWS, 0.0, 5.0/12.0/sqrt(DRAWS), "along %s: correlation with the next",
             word_name[word]);
}

/* chi square over 256 cells has mean 255 and standard deviation sqrt(510), for each of the eight
   bytes */
static void uniform_bytes(int word)
{
    static int count[8][CELLS];
    double worst = 0.0;

    for (int i = 0; i < 8*CELLS; i++)
    {
        count[i/CELLS][i%CELLS] = 0;
    }
    for (uint64_t i = 0; i < DRAWS; i++)
    {
        const uint64_t bits = bits_along(word, i);

        for (int b = 0; b < 8; b++)
        {
            count[b][bits >> 8*b & 255]++;
        }
    }
    for (int b = 0; b < 8; b++)
    {
        const double expected = (double)DRAWS/CELLS;
        double chi = 0.0;

        for (int v = 0; v < CELLS; v++)
        {
            chi += (count[b][v] - expected)*(count[b][v] - expected)/expected;
        }
        worst = fmax(worst, fabs(chi - 255.0)/sqrt(510.0));
    }
    TAP_OK(worst < 5.0, "along %s: the values of every byte are uniform, %.1f standard deviations",
           word_name[word], worst);
}

/* pairs of successive draws fill the square: chi square over 64 x 64 cells, mean 4095, standard
   deviation sqrt(8190) */
static void uniform_pairs(int word)
{
    static int count[64][64];
    const double expected = DRAWS/4096.0;
    double chi = 0.0;

    for (int i = 0; i < 4096; i++)
    {
        count[i/64][i%64] = 0;
    }
    for (uint64_t i = 0; i < DRAWS; i++)
    {
        count[bits_along(word, 2*i) >> 58][bits_along(word, 2*i + 1) >> 58]++;
    }
    for (int i = 0; i < 4096; i++)
    {
        chi += (count[i/64][i%64] - expected)*(count[i/64][i%64] - expected)/expected;
    }
    TAP_OK(fabs(chi - 4095.0) < 5.0*sqrt(8190.0),
           "along %s: pairs fill the square, %.1f standard deviations", word_name[word],
           (chi - 4095.0)/sqrt(8190.0));
}

/* flipping one bit of a word flips each bit of the result in half of all cases: 4000 trials, 64 x
   64 bits. For low input bits each trial is counted twice, which widens a standard deviation of
   sqrt(n)/2 by sqrt(2); 5.5 of them, because the largest of 4096 counts is taken */
static void avalanche(int word)
{
    enum
    {
        TRIALS = 4000
    };
    static int turned[64][64];
    double worst = 0.0;

    for (int in = 0; in < 64; in++)
    {
        for (int out = 0; out < 64; out++)
        {
            turned[in][out] = 0;
        }
        for (uint64_t i = 0; i < TRIALS; i++)
        {
            const uint64_t difference =
                bits_along(word, i) ^ bits_along(word, i ^ UINT64_C(1) << in);

            for (int out = 0; out < 64; out++)
            {
                turned[in][out] += (int)(difference >> out & 1);
            }
        }
        for (int out = 0; out < 64; out++)
        {
            worst = fmax(worst, fabs(turned[in][out] - TRIALS/2.0)/(0.5*sqrt(TRIALS)));
        }
    }
    TAP_OK(worst < 5.5*sqrt(2.0),
           "along %s: avalanche, each bit on each, %.1f standard deviations at worst",
           word_name[word], worst);
}

static int by_value(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;

    return (x > y) - (x < y);
}

/* a million draws over a grid of (id, step): n^2/2^33 = 128 pairs have equal upper halves, standard
   deviation 11 */
static void birthdays(void)
{
    enum
    {
        SIDE = 1024
    };
    uint32_t *half = malloc(sizeof *half*SIDE*SIDE);
    int equal_pairs = 0;

    for (uint32_t i = 0; i < SIDE*SIDE; i++)
    {
        half[i] = (uint32_t)(dem_random_bits(1, i%SIDE, i/SIDE, 0) >> 32);
    }
    qsort(half, SIDE*SIDE, sizeof *half, by_value);
    for (int i = 1; i < SIDE*SIDE; i++)
    {
        equal_pairs += half[i] == half[i - 1];
    }
    TAP_OK(abs(equal_pairs - 128) < 57, "%d equal pairs among a million draws over ids and steps, 128 expected",
           equal_pairs);
    free(half);
}

int main(void)
{
    TAP_TRAPS;
    /* calculated with integers of any length, outside of the C code */
    TAP_OK(dem_random_bits(1, 2, 3, 4) == UINT64_C(0xd55ccd4aeb3ccafb),
           "the bits of (1, 2, 3, 4) are fixed");
    TAP_OK(dem_random_bits(UINT64_MAX, 0, UINT64_MAX, 7) == UINT64_C(0x7a025378bfc0b2a1),
           "the bits of extreme words are fixed");
    TAP_OK(dem_random_bits(1, 2, 3, 4) != dem_random_bits(2, 1, 3, 4)
           && dem_random_bits(1, 2, 3, 4) != dem_random_bits(1, 2, 4, 3),
           "the words are not interchangeable");
    for (int word = 0; word < WORDS; word++)
    {
        moments(word);
        uniform_bytes(word);
        uniform_pairs(word);
        avalanche(word);
    }
    birthdays();
    TAP_DONE;
}
