/*
 * sum.c -- exact sum of doubles as one wide integer, rounded once when its value is read.
 *
 * A number is added to three limbs, less than 2^32 on each (sum_digits.h); so an int64 limb holds 2^31
 * additions, and carries are propagated after 2^30. All operations are on integers: nothing rounds
 * or raises a floating-point exception.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/sum.h"
#include "core/sum_digits.h"
#include <string.h>

#define DIGIT 0xffffffffu

enum
{
    MAX_ADDED = 1 << 30,  /* additions between two propagations of carries */
    MANTISSA = 53         /* bits of the mantissa of a double */
};

void dem_sum_clear(struct dem_sum *s)
{
    memset(s, 0, sizeof *s);
}

void dem_sum_normalise(struct dem_sum *s)
{
    int64_t carry = 0;

    for (int i = 0; i < DEM_SUM_LIMBS - 1; i++)
    {
        const int64_t whole = s->part[i] + carry;
        const int64_t digit = whole & DIGIT;

        carry = (whole - digit)/(DIGIT + INT64_C(1));
        s->part[i] = digit;
    }
    s->part[DEM_SUM_LIMBS - 1] += carry;
    s->part[DEM_SUM_ADDED] = 0;
}

void dem_sum_add(struct dem_sum *s, double value)
{
    dem_sum_add_times(s, value, 1);
}

void dem_sum_add_times(struct dem_sum *s, double value, int64_t n)
{
    struct dem_sum_digits d;

    if (!dem_sum_digits_of(value, &d))
    {
        const uint64_t bits = dem_math_bits(value);

        s->part[bits & 0xfffffffffffffu ? DEM_SUM_NAN
                : bits >> 63            ? DEM_SUM_MINUS
                                        : DEM_SUM_PLUS] += n;
        return;
    }
    if (n > 1 && s->part[DEM_SUM_ADDED] + n > MAX_ADDED)
    {
        dem_sum_normalise(s);
    }
    for (int k = 0; k < 3; k++)
    {
        s->part[d.first + k] += n*d.digit[k];
    }
    s->part[DEM_SUM_ADDED] += n;
    if (s->part[DEM_SUM_ADDED] >= MAX_ADDED)
    {
        dem_sum_normalise(s);
    }
}

static double from_bits(uint64_t bits)
{
    double value;

    memcpy(&value, &bits, sizeof value);
    return value;
}

/* Bit b of the wide integer and the 63 bits below it, with b as the highest bit of a word. */
static uint64_t window(const int64_t *limb, int b)
{
    uint64_t word = 0;

    for (int i = 0; i < 64; i++)
    {
        const int at = b - i;

        word = word << 1 | (at >= 0 ? (uint64_t)limb[at/32] >> at%32 & 1u : 0u);
    }
    return word;
}

/* Is any bit below bit b set? */
static int any_below(const int64_t *limb, int b)
{
    for (int i = 0; i < b/32; i++)
    {
        if (limb[i])
        {
            return 1;
        }
    }
    return b > 0 && ((uint64_t)limb[b/32] & ((UINT64_C(1) << b%32) - 1)) != 0;
}

/* The bits of the double nearest to a normalised wide integer >= 0 whose highest bit is `top`; ties
   to even. */
static uint64_t nearest(const int64_t *limb, int top)
{
    if (top < MANTISSA)
    {
        /* exact: the double has the bits of the integer */
        return window(limb, MANTISSA - 1) >> 11;
    }

    const uint64_t word = window(limb, top);
    const uint64_t m = word >> 11, rest = word & 0x7ff, half = 0x400;
    const int up = rest > half || (rest == half && (any_below(limb, top - 63) || (m & 1)));

    if (top - MANTISSA + 2 >= 0x7ff)
    {
        return UINT64_C(0x7ff) << 52;
    }
    /* m contains the hidden bit, which adds one to the exponent; so does a carry out of m */
    return ((uint64_t)(top - MANTISSA + 1) << 52) + m + (uint64_t)up;
}

double dem_sum_value(const struct dem_sum *of)
{
    const uint64_t infinite = UINT64_C(0x7ff) << 52, minus = UINT64_C(1) << 63;
    struct dem_sum s = *of;

    if (s.part[DEM_SUM_NAN] || (s.part[DEM_SUM_PLUS] && s.part[DEM_SUM_MINUS]))
    {
        return from_bits(infinite | UINT64_C(1) << 51);
    }
    if (s.part[DEM_SUM_PLUS] || s.part[DEM_SUM_MINUS])
    {
        return from_bits(s.part[DEM_SUM_PLUS] ? infinite : infinite | minus);
    }

    dem_sum_normalise(&s);

    const int negative = s.part[DEM_SUM_LIMBS - 1] < 0;

    if (negative)
    {
        for (int i = 0; i < DEM_SUM_LIMBS; i++)
        {
            s.part[i] = -s.part[i];
        }
        dem_sum_normalise(&s);
    }

    int top = 32*DEM_SUM_LIMBS - 1;

    while (top >= 0 && !((uint64_t)s.part[top/32] >> top%32 & 1u))
    {
        top--;
    }
    return top < 0 ? 0.0 : from_bits(nearest(s.part, top) | (negative ? minus : 0));
}
