/*
 * binned_sum.h -- exact sums of six quantities at once, fast while their terms are of similar size.
 *
 * A term is split into a multiple of a unit and a multiple of 2^-47 units. Sums of either are exact
 * in double for 64 terms, and then go to the wide integers of sum.h. A term that is no sum of two
 * such multiples goes there at once. So the result has the bits of sum.h, whatever the unit and the
 * order.
 * Source: Demmel and Nguyen, "Parallel reproducible summation", IEEE Trans. Comput. 64 (2015).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/sum.h"

enum
{
    DEM_BINNED_SUMS = 6
};

struct dem_binned_sum
{
    struct dem_sum sum[DEM_BINNED_SUMS];    /* without the terms in the bins */
    double unit;                            /* power of two; 0: no term so far */
    double high[DEM_BINNED_SUMS], low[DEM_BINNED_SUMS];
    int added;                              /* terms in the bins */
};

void dem_binned_sum_clear(struct dem_binned_sum *);
void dem_binned_sum_add(struct dem_binned_sum *, const double term[DEM_BINNED_SUMS]);

/* Add the bins to `sum`: before it is read. */
void dem_binned_sum_flush(struct dem_binned_sum *);
