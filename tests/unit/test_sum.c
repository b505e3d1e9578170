/*
 * test_sum.c -- an exact sum has the bits of the correctly rounded true sum, in any order, from any
 * number of ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Three independent references: IEEE 754 addition is correctly rounded for two terms, 128-bit
 * integers represent many terms exactly, and sums with cancellation have a known remainder. There
 * is no tolerance.
 */
#include "tap.h"

#include "core/binned_sum.h"
#include "core/random.h"

#include <float.h>
#include <stdint.h>
#include <string.h>

__extension__ typedef __int128 wide;

enum
{
    TERMS = 10000
};

static double term[TERMS];

static int same_bits(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

static double sum_of(const double *value, int n)
{
    struct dem_sum s;

    dem_sum_clear(&s);
    for (int i = 0; i < n; i++)
    {
        dem_sum_add(&s, value[i]);
    }
    return dem_sum_value(&s);
}

/* any finite double, or one within 2^60 of 1 so that the two terms meet */
static double any_double(uint64_t id, uint64_t use)
{
    const uint64_t bits = dem_random_bits(3, id, 0, use);
    const uint64_t near = (bits & 0x800fffffffffffffu) | (UINT64_C(0x3ff) - bits%60) << 52;
    const uint64_t chosen = id%2 && (bits >> 52 & 0x7ff) < 0x7ff ? bits : near;
    double value;

    memcpy(&value, &chosen, sizeof value);
    return value;
}

static void two_terms(void)
{
    int bad = 0;

    for (uint64_t i = 0; i < 400000; i++)
    {
        const double a = any_double(i, 0), b = any_double(i, 1), two[2] = {a, b};
        const double expected = a + b;

        bad += !same_bits(sum_of(two, 2), expected == 0.0 ? 0.0 : expected);
    }
    TAP_OK(bad == 0, "two terms: the processor's own addition, 400000 pairs, %d wrong", bad);
}

static void many_terms(void)
{
    int bad = 0;

    for (uint64_t trial = 0; trial < 200; trial++)
    {
        const int n = 1 + (int)(dem_random_bits(4, trial, 0, 0)%TERMS);
        wide exact = 0;

        for (int i = 0; i < n; i++)
        {
            const uint64_t bits = dem_random_bits(4, trial, (uint64_t)i, 1);
            const int64_t whole = (int64_t)(bits >> 11)*(bits & 1 ? 1 : -1);
            const int scale = (int)(bits >> 1 & 0x3f)%50;

            term[i] = ldexp((double)whole, scale);
            exact += (wide)whole*((wide)1 << scale);
        }
        bad += !same_bits(sum_of(term, n), (double)exact);
    }
    TAP_OK(bad == 0, "many terms: 128-bit integers rounded once, 200 sums, %d wrong", bad);
}

static void known_sums(void)
{
    const double tiny = 0x1p-1074, ulp = DBL_EPSILON;

    TAP_OK(same_bits(sum_of((double[]){1e308, 1.0, -1e308}, 3), 1.0), "1e308 + 1 - 1e308 is 1");
    TAP_OK(same_bits(sum_of((double[]){DBL_MAX, DBL_MAX, tiny, -DBL_MAX, -DBL_MAX}, 5), tiny),
           "twice the largest cancels and leaves the smallest");
    TAP_OK(same_bits(sum_of((double[]){1.0, ulp/2}, 2), 1.0),
           "a tie rounds to the even neighbor below");
    TAP_OK(same_bits(sum_of((double[]){1.0 + ulp, ulp/2}, 2), 1.0 + 2*ulp),
           "a tie rounds to the even neighbor above");
    TAP_OK(same_bits(sum_of((double[]){1.0, ulp/2, tiny}, 3), 1.0 + ulp),
           "the smallest double breaks a tie upwards");
    TAP_OK(same_bits(sum_of((double[]){1.0 + ulp, ulp/2, -tiny}, 3), 1.0 + ulp),
           "the smallest double breaks a tie downwards");
    TAP_OK(same_bits(sum_of((double[]){-1.0, -ulp/2, -tiny}, 3), -1.0 - ulp),
           "a negative sum mirrors a positive one");
    TAP_OK(same_bits(sum_of((double[]){2.0 - ulp, ulp/2}, 2), 2.0),
           "rounding may carry into the exponent");
    TAP_OK(same_bits(sum_of((double[]){DBL_MIN, -tiny}, 2), DBL_MIN - tiny),
           "subnormal numbers are exact");
    TAP_OK(same_bits(sum_of((double[]){3*tiny, -5*tiny}, 2), -2*tiny),
           "subnormal numbers are exact to the last bit");
    TAP_OK(same_bits(sum_of((double[]){0.0, -0.0}, 2), 0.0) && same_bits(sum_of(term, 0), 0.0),
           "the empty sum is +0");
    TAP_OK(same_bits(sum_of((double[]){DBL_MAX, DBL_MAX}, 2), INFINITY)
           && same_bits(sum_of((double[]){-DBL_MAX, -DBL_MAX}, 2), -INFINITY),
           "beyond the largest double the sum is infinite");
    TAP_OK(same_bits(sum_of((double[]){DBL_MAX, 0x1p969}, 2), DBL_MAX),
           "less than half a step beyond it is not");
    TAP_OK(same_bits(sum_of((double[]){DBL_MAX, 0x1p970}, 2), INFINITY),
           "half a step beyond it is");
}

static void any_order(void)
{
    struct dem_sum rank[7], total;
    double forwards, backwards;

    for (int i = 0; i < TERMS; i++)
    {
        term[i] = ldexp(dem_random_unit(5, (uint64_t)i, 0, 0) - 0.5,
                        (int)(dem_random_bits(5, (uint64_t)i, 0, 1)%200));
    }
    forwards = sum_of(term, TERMS);
    for (int i = 0; i < TERMS/2; i++)
    {
        const double t = term[i];

        term[i] = term[TERMS - 1 - i];
        term[TERMS - 1 - i] = t;
    }
    backwards = sum_of(term, TERMS);
    TAP_OK(same_bits(forwards, backwards), "forwards and backwards: %a", forwards);

    /* as MPI_SUM: limb by limb */
    for (int r = 0; r < 7; r++)
    {
        dem_sum_clear(rank + r);
        for (int i = r; i < TERMS; i += 7)
        {
            dem_sum_add(rank + r, term[i]);
        }
    }
    dem_sum_clear(&total);
    for (int r = 6; r >= 0; r--)
    {
        dem_sum_normalise(rank + r);
        for (int i = 0; i < DEM_SUM_PARTS; i++)
        {
            total.part[i] += rank[r].part[i];
        }
    }
    TAP_OK(same_bits(dem_sum_value(&total), forwards), "reduced from seven ranks");
}

static void many_additions(void)
{
    const int64_t n = 100000000, whole = (INT64_C(1) << 53) - 1;
    struct dem_sum s;

    dem_sum_clear(&s);
    for (int64_t i = 0; i < n; i++)
    {
        dem_sum_add(&s, (double)whole);
    }
    TAP_OK(same_bits(dem_sum_value(&s), (double)((wide)n*whole)),
           "a hundred million additions without a carry");

    dem_sum_clear(&s);
    for (int64_t k = 0; k < n; k += n/100)
    {
        dem_sum_add_times(&s, (double)whole, n/100);
        dem_sum_add_times(&s, -0.3, k);
        dem_sum_add_times(&s, 0.3, k);
    }
    TAP_OK(same_bits(dem_sum_value(&s), (double)((wide)n*whole)), "the same at a hundred times");

    /* 2^40 times the sum by doubling: every limb carries again and again */
    for (int i = 0; i < 40; i++)
    {
        dem_sum_normalise(&s);
        for (int k = 0; k < DEM_SUM_PARTS; k++)
        {
            s.part[k] *= 2;
        }
    }
    TAP_OK(same_bits(dem_sum_value(&s), ldexp((double)((wide)n*whole), 40)), "doubled forty times");

    /* full limbs: after 2^30 - 1 additions the next one must carry before a limb can overflow */
    dem_sum_clear(&s);
    s.part[10] = INT64_C(1) << 62;
    s.part[DEM_SUM_ADDED] = (1 << 30) - 1;
    dem_sum_add(&s, 1.0);
    TAP_OK(s.part[10] == 0 && s.part[11] == 1 << 30 && s.part[DEM_SUM_ADDED] == 0,
           "carries are made before a limb overflows");
}

static void not_numbers(void)
{
    TAP_OK(isnan(sum_of((double[]){1.0, NAN, 2.0}, 3)), "a not-a-number is not lost");
    TAP_OK(same_bits(sum_of((double[]){1.0, INFINITY, -DBL_MAX}, 3), INFINITY),
           "an infinity is not lost");
    TAP_OK(same_bits(sum_of((double[]){-INFINITY, DBL_MAX}, 2), -INFINITY),
           "a negative infinity is not lost");
    TAP_OK(isnan(sum_of((double[]){INFINITY, -INFINITY}, 2)),
           "both infinities give a not-a-number");
}

/* Forces of contacts: of one size, some far smaller, some 0, and later ever larger ones. */
static double force(uint64_t i, uint64_t k)
{
    const uint64_t bits = dem_random_bits(6, i, k, 0);
    const int smaller = bits%8 == 0 ? (int)(bits/8%60) : 0;
    const int larger = i > TERMS/2 ? (int)(i/100) : 0;

    return bits%16 == 1 ? 0.0
                        : ldexp(dem_random_unit(6, i, k, 1) - 0.5, larger - smaller - 30);
}

/* Any finite double; in the last tenth also infinite ones and not-a-numbers. */
static double any(uint64_t i, uint64_t k)
{
    const uint64_t bits = dem_random_bits(7, i, k, 0);
    double value;

    memcpy(&value, &bits, sizeof value);
    return isfinite(value) || 10*i >= 9*(uint64_t)TERMS ? value : 1.0;
}

/* The number of binned sums that differ from the exact ones, after every thousand terms. */
static int binned_sums_differ(double (*value)(uint64_t i, uint64_t k))
{
    struct dem_binned_sum binned;
    struct dem_sum exact[DEM_BINNED_SUMS];
    int bad = 0;

    dem_binned_sum_clear(&binned);
    memset(exact, 0, sizeof exact);
    for (uint64_t i = 0; i < TERMS; i++)
    {
        double six[DEM_BINNED_SUMS];

        for (uint64_t k = 0; k < DEM_BINNED_SUMS; k++)
        {
            six[k] = value(i, k);
            dem_sum_add(&exact[k], six[k]);
        }
        dem_binned_sum_add(&binned, six);
        if (i%1000 == 999)
        {
            struct dem_binned_sum now = binned;

            dem_binned_sum_flush(&now);
            for (int k = 0; k < DEM_BINNED_SUMS; k++)
            {
                bad += !same_bits(dem_sum_value(&now.sum[k]), dem_sum_value(&exact[k]));
            }
        }
    }
    return bad;
}

static void binned_sums(void)
{
    fenv_t traps;
    const int forces = binned_sums_differ(force);

    feholdexcept(&traps);
    const int all = binned_sums_differ(any);

    fesetenv(&traps);
    TAP_OK(forces == 0, "binned sums of terms of similar size are exact, %d wrong", forces);
    TAP_OK(all == 0, "binned sums of any doubles are exact, %d wrong", all);
}

int main(void)
{
    /* only invalid operations trap: the reference of two terms overflows on purpose */
    feenableexcept(FE_INVALID);
    two_terms();
    TAP_TRAPS;
    many_terms();
    known_sums();
    any_order();
    many_additions();
    not_numbers();
    binned_sums();
    TAP_DONE;
}
