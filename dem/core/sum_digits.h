/*
 * sum_digits.h -- the digits of a double as a wide integer (sum.h). Devices compile it, too.
 *
 * A finite double is m 2^p in units of 2^-1074, with m an integer of 53 bits and 0 <= p <= 2045. It
 * has three digits from p/32 on, less than 2^32 each.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/device.h"

struct dem_sum_digits
{
    int first;
    int64_t digit[3];    /* with the sign of the number */
};

/* The digits of a number. Returns 0 when it is not finite. */
DEM_MATH int dem_sum_digits_of(double value, struct dem_sum_digits *d)
{
    const uint64_t bits = dem_math_bits(value), fraction = bits & 0xfffffffffffffu,
                   low_digit = 0xffffffffu;
    const int exponent = (int)(bits >> 52 & 0x7ff), p = exponent ? exponent - 1 : 0,
              shift = p%32;
    const uint64_t m = exponent ? fraction | (uint64_t)1 << 52 : fraction;
    const uint64_t low = (m & low_digit) << shift, high = (m >> 32) << shift;
    const uint64_t middle = (low >> 32) + (high & low_digit);    /* no carry: they share no bit */
    const int64_t sign = bits >> 63 ? -1 : 1;

    d->first = p/32;
    d->digit[0] = sign*(int64_t)(low & low_digit);
    d->digit[1] = sign*(int64_t)middle;
    d->digit[2] = sign*(int64_t)(high >> 32);
    return exponent != 0x7ff;
}
