/*
 * sum.h -- sums of doubles that are exact, so their bits don't depend on the order or on the number of ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A sum is one wide integer in units of 2^-1074 (the smallest double), kept as 68 digits of 32 bits in int64
 * limbs: 66 for every finite double, two for carries. Adding is integer addition, hence order-free; the value
 * is rounded once, to nearest even, when asked for. After Kulisch, "Computer Arithmetic and Validity", 2013.
 *
 *     struct dem_sum s;
 *     dem_sum_clear(&s);
 *     dem_sum_add(&s, 0.5*m*v*v);
 *     dem_sum_normalise(&s);      before a reduction: MPI_SUM over s.part, DEM_SUM_PARTS numbers, MPI_INT64_T
 *     double energy = dem_sum_value(&s);
 *
 * The parts after the limbs count what is not a number and not finite, so that these too survive a reduction.
 */
#ifndef DEM_BASE_SUM_H
#define DEM_BASE_SUM_H

#include <stdint.h>

enum
{
    DEM_SUM_LIMBS = 68,                       /* digits of 32 bits                           */
    DEM_SUM_NAN = DEM_SUM_LIMBS,              /* how many not-a-numbers were added           */
    DEM_SUM_PLUS,                             /* how many +infinities                        */
    DEM_SUM_MINUS,                            /* how many -infinities                        */
    DEM_SUM_ADDED,                            /* additions since the last normalise          */
    DEM_SUM_PARTS                             /* int64 numbers to hand to a reduction        */
};

struct dem_sum
{
    int64_t part[DEM_SUM_PARTS];
};

void dem_sum_clear(struct dem_sum *s);
void dem_sum_add(struct dem_sum *s, double value);                     /* any double; any number of times */
void dem_sum_merge(struct dem_sum *s, const struct dem_sum *other);    /* s += other */
void dem_sum_normalise(struct dem_sum *s);    /* carry; then up to 2^30 ranks may be added up */

/* The exact sum rounded to nearest, ties to even; infinite past the largest double or after an infinity;
   not-a-number after one, or after both infinities. Raises no floating-point exception. */
double dem_sum_value(const struct dem_sum *s);

#endif
