/*
 * device.h -- what arithmetic needs from its language: C17 on a CPU, OpenCL C on a device.
 *
 * The row functions of laws/ are compiled by both and give the same bits. They use + - * / sqrt
 * fabs ?:, core/math.h and core/random.h. OpenCL C has these limits beside C17:
 *
 *   `half` is a type, not a name
 *   no pointer to a literal, as (double[3]){...}, and no variable outside of functions
 *   no header of the C library: this file includes what rows use of it
 *
 * On a device pointers without a qualifier are private to a row, which is what rows need.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#ifdef __OPENCL_C_VERSION__

#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

typedef char int8_t;
typedef uchar uint8_t;
typedef ushort uint16_t;
typedef uint uint32_t;
typedef ulong uint64_t;
typedef long int64_t;

#define DEM_MATH static inline

#define dem_math_bits(x) as_ulong(x)
#define dem_math_from_bits(bits) as_double(bits)
#define dem_select(yes, a, b) ((yes) ? (double)(a) : (double)(b))

#else

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* always inlined: one call left in a loop keeps the loop scalar, and compilers find pow too long */
#define DEM_MATH static inline __attribute__((always_inline))

DEM_MATH uint64_t dem_math_bits(double x)
{
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    return bits;
}

DEM_MATH double dem_math_from_bits(uint64_t bits)
{
    double x;

    memcpy(&x, &bits, sizeof x);
    return x;
}

/* yes ? a : b by masks, yes being 0 or 1: with ?: gcc moves the arithmetic of a and b into a branch
   and the loop stays scalar */
DEM_MATH double dem_select(int yes, double a, double b)
{
    const uint64_t mask = (uint64_t)0 - (uint64_t)yes;

    return dem_math_from_bits((dem_math_bits(a) & mask) | (dem_math_bits(b) & ~mask));
}

#endif
