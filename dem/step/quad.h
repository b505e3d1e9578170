/*
 * quad.h -- four numbers that lie side by side, e.g. {x, y, z, radius} of a record, in one register.
 *
 * The rows of four records turn into four columns in registers, and back: several times faster than number by number,
 * and the same bits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_QUAD_H
#define DEM_STEP_QUAD_H

typedef double dem_quad __attribute__((vector_size(32), aligned(16), may_alias));

/* Four numbers in memory; not a function, because a vector returned has no fixed calling convention without AVX. */
#define DEM_QUAD(from) (*(const dem_quad *)(const void *)(from))
#define DEM_QUAD_AT(to) (*(dem_quad *)(void *)(to))

/* The same in single precision, and from one to the other. */
typedef float dem_quad_single __attribute__((vector_size(16), aligned(16), may_alias));
#define DEM_QUAD_SINGLE(from) (*(const dem_quad_single *)(const void *)(from))
#define DEM_QUAD_SINGLE_AT(to) (*(dem_quad_single *)(void *)(to))
#define DEM_QUAD_WIDEN(four) __builtin_convertvector(four, dem_quad)
#define DEM_QUAD_NARROW(four) __builtin_convertvector(four, dem_quad_single)

/* Rows become columns, or columns rows. */
__attribute__((always_inline)) static inline void dem_quad_turn(dem_quad row[4])
{
    const dem_quad a = __builtin_shufflevector(row[0], row[1], 0, 4, 2, 6), b = __builtin_shufflevector(row[0], row[1], 1, 5, 3, 7);
    const dem_quad c = __builtin_shufflevector(row[2], row[3], 0, 4, 2, 6), d = __builtin_shufflevector(row[2], row[3], 1, 5, 3, 7);

    row[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
    row[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    row[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    row[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

__attribute__((always_inline)) static inline void dem_quad_turn_single(dem_quad_single row[4])
{
    const dem_quad_single a = __builtin_shufflevector(row[0], row[1], 0, 4, 1, 5), b = __builtin_shufflevector(row[0], row[1], 2, 6, 3, 7);
    const dem_quad_single c = __builtin_shufflevector(row[2], row[3], 0, 4, 1, 5), d = __builtin_shufflevector(row[2], row[3], 2, 6, 3, 7);

    row[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
    row[1] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    row[2] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    row[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

#endif
