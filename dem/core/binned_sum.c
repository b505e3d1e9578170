/*
 * binned_sum.c -- a term is rounded to a multiple of the unit by adding and subtracting 1.5 2^52
 * units.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/binned_sum.h"
#include <math.h>
#include <string.h>

enum
{
    MAX_ADDED = 64,     /* terms below 2^47 units: a bin is then below 2^53 units */
    SPARE_BITS = 4      /* later terms may be larger by this before the unit changes */
};

static const double max_term = 0x1p47, low_unit = 0x1p-47, rounder = 0x1.8p52;

void dem_binned_sum_clear(struct dem_binned_sum *s)
{
    memset(s, 0, sizeof *s);
}

void dem_binned_sum_flush(struct dem_binned_sum *s)
{
    for (int k = 0; k < DEM_BINNED_SUMS; k++)
    {
        dem_sum_add(&s->sum[k], s->high[k]);
        dem_sum_add(&s->sum[k], s->low[k]);
        s->high[k] = s->low[k] = 0.0;
    }
    s->added = 0;
}

/* A unit for terms up to `largest`. */
static void choose_unit(struct dem_binned_sum *s, double largest)
{
    int exponent;

    if (largest > 0.0 && isfinite(largest))
    {
        dem_binned_sum_flush(s);
        frexp(largest/max_term, &exponent);
        s->unit = ldexp(1.0, exponent + SPARE_BITS);
    }
}

void dem_binned_sum_add(struct dem_binned_sum *s, const double term[DEM_BINNED_SUMS])
{
    double high[DEM_BINNED_SUMS], low[DEM_BINNED_SUMS], largest = 0.0;
    int fits = 1;

    for (int k = 0; k < DEM_BINNED_SUMS; k++)
    {
        largest = fabs(term[k]) > largest ? fabs(term[k]) : largest;
    }
    if (!(largest < max_term*s->unit))
    {
        choose_unit(s, largest);
    }
    const double to_high = rounder*s->unit, to_low = low_unit*to_high;

    for (int k = 0; k < DEM_BINNED_SUMS; k++)
    {
        high[k] = (term[k] + to_high) - to_high;
        low[k] = ((term[k] - high[k]) + to_low) - to_low;
        fits &= (term[k] - high[k]) - low[k] == 0.0;
    }
    for (int k = 0; k < DEM_BINNED_SUMS; k++)
    {
        if (fits)
        {
            s->high[k] += high[k];
            s->low[k] += low[k];
        }
        else
        {
            dem_sum_add(&s->sum[k], term[k]);
        }
    }
    s->added += fits;
    if (s->added == MAX_ADDED)
    {
        dem_binned_sum_flush(s);
    }
}
