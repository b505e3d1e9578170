/*
 * sum.h -- exact sums of doubles: the same bits for any order of the terms and any number of ranks.
 *
 * A sum is one wide integer in units of 2^-1074 (the smallest double), stored as 68 digits of 32
 * bits in int64 limbs: 66 for every finite double, two for carries. Adding is integer addition,
 * hence order-free; the value is rounded once, to nearest even, when it is read. Source: Kulisch,
 * "Computer Arithmetic and Validity", 2013.
 *
 *     struct dem_sum s = {0};
 *     dem_sum_add(&s, 0.5*m*v*v);
 *     dem_sum_normalise(&s);      before a reduction: MPI_SUM of s.part, DEM_SUM_PARTS of
 *                                 MPI_INT64_T
 *     double energy = dem_sum_value(&s);
 *
 * The parts after the limbs count the NaN and infinite terms, so that these too survive a
 * reduction.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <stdint.h>

enum
{
    DEM_SUM_LIMBS = 68,           /* digits of 32 bits */
    DEM_SUM_NAN = DEM_SUM_LIMBS,  /* number of NaN terms */
    DEM_SUM_PLUS,                 /* number of +infinity terms */
    DEM_SUM_MINUS,                /* number of -infinity terms */
    DEM_SUM_ADDED,                /* additions since the last normalisation */
    DEM_SUM_PARTS                 /* int64 numbers of a reduction */
};

struct dem_sum
{
    int64_t part[DEM_SUM_PARTS];
};

void dem_sum_clear(struct dem_sum *s);                /* begin again */
void dem_sum_add(struct dem_sum *s, double value);    /* any double; any number of times */
/* as n additions of the same value, 0 <= n <= 2^30 */
void dem_sum_add_times(struct dem_sum *s, double value, int64_t n);
/* propagate carries; then up to 2^30 ranks may be added */
void dem_sum_normalise(struct dem_sum *s);

/* The exact sum rounded to nearest, ties to even; infinite beyond the largest double or with an
   infinite term; NaN with a NaN term or with both infinities. Raises no floating-point
   exception. */
double dem_sum_value(const struct dem_sum *s);
