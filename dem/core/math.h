/*
 * math.h -- exp, log, pow and related functions with the same bits on every machine, in loops that
 * vectorise.
 *
 * The C library's functions differ between its versions and between processors. The functions here
 * use + - * / and integer operations on the bits only, so a compiler that keeps to IEEE 754 (no
 * -ffast-math, -ffp-contract=off, rounding to nearest) has no choice in any bit. They have no
 * branch and no table, so a loop that calls them becomes vector code. dem_select (core/device.h)
 * serves any kernel whose ?: keeps its loop scalar. OpenCL C compiles this header, too.
 *
 *   e^x     x = k ln 2 + r, |r| <= ln 2 / 2;  e^r = 1 + r + r^2 Q(r);
 *           k is added to the exponent's bits
 *   ln x    x = 2^k (1 + f), sqrt(1/2) <= 1 + f < sqrt(2);  s = f/(2 + f);
 *           ln(1 + f) = 2 artanh(s) = f - s (f - s^2 P(s^2)),  because 2 s = f - s f
 *   x^y     the same logarithm with its rounding error kept, times y in two halves, so that y ln x
 *           is known to 1e-15 where it reaches several hundred
 *
 * Q (degree 10) and P (degree 6) interpolate (e^r - 1 - r)/r^2 and (2 artanh(s) - 2 s)/s^3 at the
 * Chebyshev nodes of the intervals above; computed in 60 digits, rounded to double. They add 9e-19
 * to the relative error of e^r - 1 and 5e-18 to the error of ln(1 + f). ln 2 and log10 2 are cut after
 * 42 binary places, so that k times the upper part is exact.
 *
 * Largest errors found against 113-bit references at 10^6 arguments each (tests/unit/test_math.c
 * repeats the comparison with the C library's long double functions), in units in the last place:
 * exp 1.0, expm1 1.7, phi 1.7, log 0.95, log10 1.9 over the whole range of double; pow 4e-16
 * relative for |y| <= 12 and x in 1e-12 .. 1e12, growing as |y| 2e-17 beyond.
 *
 * For finite arguments no function raises invalid, division by zero or overflow: a result that is
 * not a finite number is selected, not computed. A NaN argument gives NaN, and raises invalid when
 * it is compared.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/device.h"

#define DEM_MATH_LN2_HIGH 0x1.62e42fefa38p-1          /* ln 2 to 42 binary places */
#define DEM_MATH_LN2_LOW 0x1.ef35793c7673p-45         /* the rest of it */
#define DEM_MATH_LOG2_E 0x1.71547652b82fep+0          /* 1/ln 2 */
#define DEM_MATH_LOG10_2_HIGH 0x1.34413509f7p-2       /* log10 2 to 42 binary places */
#define DEM_MATH_LOG10_2_LOW 0x1.3fde623e2566bp-43    /* the rest of it */
#define DEM_MATH_LOG10_E 0x1.bcb7b1526e50ep-2         /* 1/ln 10 */

#define DEM_MATH_EXP_MAX 709.78       /* e^x is infinite above; ln DBL_MAX = 709.7827 */
#define DEM_MATH_EXP_MIN (-708.39)    /* e^x is zero below; ln DBL_MIN = -708.3964 */
#define DEM_MATH_SHIFTER 0x1.8p52     /* adding it leaves an integer in the low bits */

/* e^r - 1 - r for |r| <= ln 2 / 2; even and odd powers apart, for shorter dependences */
DEM_MATH double dem_math_exp_tail(double r)
{
    const double z = r*r;
    const double even = 0x1p-1 + z*(0x1.5555555555556p-5 + z*(0x1.6c16c16c162d4p-10
                      + z*(0x1.a01a01a6d889cp-16
                      + z*(0x1.27e4db646b17ep-22 + z*0x1.1f730349868cep-29))));
    const double odd = 0x1.5555555555557p-3 + z*(0x1.11111111100dcp-7 + z*(0x1.a01a01abe7fe1p-13
                     + z*(0x1.71de0231960ebp-19 + z*0x1.af4de97ca4194p-26)));

    return z*(even + r*odd);
}

/* x > 0 as 2^k (1 + f), sqrt(1/2) <= 1 + f < sqrt(2); exact. Other x: a meaningless finite
   result, no exception. */
DEM_MATH double dem_math_split(double x, double *f)
{
    const uint64_t root = 0x3fe6a09e667f3bcdu;    /* bits of sqrt(1/2) */
    const double scale = dem_select(fabs(x) < DBL_MIN, 0x1p54, 1.0);
    const double shift = dem_select(fabs(x) < DBL_MIN, 0x1p52 + 1023.0 + 54.0, 0x1p52 + 1023.0);
    const uint64_t u = dem_math_bits(x*scale) + (0x3ff0000000000000u - root);

    *f = dem_math_from_bits((u & 0x000fffffffffffffu) + root) - 1.0;
    return dem_math_from_bits(0x4330000000000000u | (u >> 52)) - shift;
}

/* f - ln(1 + f) for sqrt(1/2) <= 1 + f < sqrt(2) */
DEM_MATH double dem_math_log_tail(double f)
{
    const double s = f/(2.0 + f);
    const double z = s*s, w = z*z;
    const double even = 0x1.5555555555558p-1 + w*(0x1.2492492df281ap-2
                      + w*(0x1.7462b51cb66b1p-3 + w*0x1.2b5900de53b32p-3));
    const double odd = 0x1.99999999952d7p-2 + w*(0x1.c71c62e3f11e6p-3 + w*0x1.39fe51a7c18f9p-3);

    return s*(f - z*(even + z*odd));
}

/* The logarithm y of x, replaced where x is not a positive finite number. */
DEM_MATH double dem_math_log_edges(double x, double y)
{
    const double bad = dem_select(x == 0.0, -INFINITY, NAN);

    y = dem_select(x <= DBL_MAX, y, x);
    return dem_select(x > 0.0, y, bad);
}

/* e^x; 0 below -708.39, infinite above 709.78 */
DEM_MATH double dem_exp(double x)
{
    const double low = dem_select(x < DEM_MATH_EXP_MIN, DEM_MATH_EXP_MIN, x);
    const double in = dem_select(low > DEM_MATH_EXP_MAX, DEM_MATH_EXP_MAX, low);
    const double shifted = in*DEM_MATH_LOG2_E + DEM_MATH_SHIFTER;
    const double k = shifted - DEM_MATH_SHIFTER;
    const double r = (in - k*DEM_MATH_LN2_HIGH) - k*DEM_MATH_LN2_LOW;
    const double e = 1.0 + (r + dem_math_exp_tail(r));
    const double y = dem_math_from_bits(dem_math_bits(e) + (dem_math_bits(shifted) << 52));
    const double z = dem_select(x < DEM_MATH_EXP_MIN, 0.0, y);

    return dem_select(x <= DEM_MATH_EXP_MAX, z, fabs(x) + INFINITY);
}

/* e^x - 1, with full relative accuracy also for small |x|; infinite above 709.78 */
DEM_MATH double dem_expm1(double x)
{
    const double low = dem_select(x < -50.0, -50.0, x);    /* e^-50 < 2^-72: -1 to the last bit */
    const double in = dem_select(low > DEM_MATH_EXP_MAX, DEM_MATH_EXP_MAX, low);
    const double shifted = in*DEM_MATH_LOG2_E + DEM_MATH_SHIFTER;
    const double k = shifted - DEM_MATH_SHIFTER;
    const double high = in - k*DEM_MATH_LN2_HIGH, less = k*DEM_MATH_LN2_LOW;
    const double r = high - less;
    const double lost = (high - r) - less;    /* rounding error of r */
    const double q = r + (dem_math_exp_tail(r) + lost);

    /* in units of power = 2^(k-1), because 2^1024 is not representable */
    const double power = dem_math_from_bits((dem_math_bits(shifted) + 1022) << 52);
    const double y = 2.0*(power*q + (power - 0.5));

    return dem_select(x <= DEM_MATH_EXP_MAX, y, fabs(x) + INFINITY);
}

/* (1 - e^-z)/z, 1 at z = 0: the mean of e^-t over 0 .. z. Used for the exact integration of linear
   drag, z = b dt/m. */
DEM_MATH double dem_phi(double z)
{
    const double divisor = dem_select(fabs(z) <= 0x1p-54, 1.0, z);
    const double y = -dem_expm1(-divisor)/divisor;

    return dem_select(fabs(z) <= 0x1p-54, 1.0, y);
}

/* ln x; -infinity at 0, NaN below */
DEM_MATH double dem_log(double x)
{
    double f;
    const double k = dem_math_split(x, &f);
    const double y = k*DEM_MATH_LN2_HIGH + (f - (dem_math_log_tail(f) - k*DEM_MATH_LN2_LOW));

    return dem_math_log_edges(x, y);
}

/* log10 x; -infinity at 0, NaN below */
DEM_MATH double dem_log10(double x)
{
    double f;
    const double k = dem_math_split(x, &f);
    const double ln = f - dem_math_log_tail(f);
    const double y = k*DEM_MATH_LOG10_2_HIGH + (ln*DEM_MATH_LOG10_E + k*DEM_MATH_LOG10_2_LOW);

    return dem_math_log_edges(x, y);
}

/* x^y for finite x >= 0 and y; 0^y is 0 for y > 0, 1 for y = 0, infinite for y < 0;
   NaN for x < 0 */
DEM_MATH double dem_pow(double x, double y)
{
    /* keeps 26 of 53 bits: the product of two is exact */
    const uint64_t upper = ~(uint64_t)0x7ffffff;

    /* ln x = up + low, where low includes the rounding error of up */
    double f;
    const double k = dem_math_split(x, &f);
    const double whole = k*DEM_MATH_LN2_HIGH;
    const double up = whole + f;
    const double low = ((whole - up) + f) + (k*DEM_MATH_LN2_LOW - dem_math_log_tail(f));

    /* y ln x = product + rest, product exact; beyond |y| = 1e20 all x but 1 give zero or
       infinity anyway */
    const double y_below = dem_select(y > 1e20, 1e20, y);
    const double y_in = dem_select(y_below < -1e20, -1e20, y_below);
    const double up_1 = dem_math_from_bits(dem_math_bits(up) & upper);
    const double y_1 = dem_math_from_bits(dem_math_bits(y_in) & upper);
    const double product = y_1*up_1;
    const double rest = (y_1*(up - up_1) + (y_in - y_1)*up) + y_in*low;
    const double power = product + rest;

    /* e^(product + rest), replaced by e^0 where the result is zero or infinite anyway */
    const double m = dem_select(fabs(power) < -DEM_MATH_EXP_MIN, product, 0.0);
    const double n = dem_select(fabs(power) < -DEM_MATH_EXP_MIN, rest, 0.0);
    const double shifted = (m + n)*DEM_MATH_LOG2_E + DEM_MATH_SHIFTER;
    const double j = shifted - DEM_MATH_SHIFTER;
    const double r = (m - j*DEM_MATH_LN2_HIGH) + (n - j*DEM_MATH_LN2_LOW);
    const double e = 1.0 + (r + dem_math_exp_tail(r));
    const double finite = dem_math_from_bits(dem_math_bits(e) + (dem_math_bits(shifted) << 52));

    /* results that are zero, infinite or NaN */
    const double small = dem_select(power <= DEM_MATH_EXP_MIN, 0.0, finite);
    const double large = dem_select(power < -DEM_MATH_EXP_MIN, small, fabs(power) + INFINITY);
    const double from_zero = dem_select(y > 0.0, 0.0, dem_select(y < 0.0, INFINITY, 1.0 + y));
    const double z = dem_select(x == 0.0, from_zero, large);

    return dem_select((x >= 0.0) & (x <= DBL_MAX), z, NAN);
}
