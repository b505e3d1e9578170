/*
 * vec4.h -- four numbers stored side by side, e.g. {x, y, z, radius} of a particle record, in one
 * vector register; eight of them, a cache line, likewise.
 *
 * Four records are transposed into four columns in registers, and back: several times faster than
 * number by number, with the same bits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ < 12
#error "Suna needs gcc 12 or later, or clang 14; name another compiler with OMPI_CC=..."
#endif

typedef double dem_vec4 __attribute__((vector_size(32), aligned(16), may_alias));

/* Four numbers in memory, to read and to write. A macro, because returning a vector has no fixed
   calling convention without AVX. */
#define DEM_VEC4(from) (*(const dem_vec4 *)(const void *)(from))
#define DEM_VEC4_AT(to) (*(dem_vec4 *)(void *)(to))

typedef double dem_vec8 __attribute__((vector_size(64), aligned(16), may_alias));

#define DEM_VEC8(from) (*(const dem_vec8 *)(const void *)(from))
#define DEM_VEC8_AT(to) (*(dem_vec8 *)(void *)(to))

/* Transpose: rows become columns, or columns rows. */
__attribute__((always_inline)) static inline void dem_transpose4(dem_vec4 row[4])
{
    const dem_vec4 a = __builtin_shufflevector(row[0], row[1], 0, 4, 2, 6),
                   b = __builtin_shufflevector(row[0], row[1], 1, 5, 3, 7);
    const dem_vec4 c = __builtin_shufflevector(row[2], row[3], 0, 4, 2, 6),
                   d = __builtin_shufflevector(row[2], row[3], 1, 5, 3, 7);

    row[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
    row[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    row[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    row[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}
