/*
 * blocks.c -- sums in blocks that double in length, and the jackknife over them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/blocks.h"
#include "base/error.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

int dem_blocks_init(struct dem_blocks *b, size_t columns)
{
    *b = (struct dem_blocks){.columns = columns, .length = 1};
    DEM_TRY(DEM_NEW(b->sum, DEM_BLOCKS*columns));
    return DEM_NEW(b->total, columns);
}

void dem_blocks_free(struct dem_blocks *b)
{
    dem_memory_free(b->sum);
    dem_memory_free(b->total);
    *b = (struct dem_blocks){.columns = 0};
}

/* Neighbours become one block of twice the length. */
static void merge(struct dem_blocks *b)
{
    for (size_t k = 0; k < DEM_BLOCKS/2; k++)
    {
        for (size_t c = 0; c < b->columns; c++)
        {
            b->sum[k*b->columns + c] = b->sum[2*k*b->columns + c] + b->sum[(2*k + 1)*b->columns + c];
        }
    }
    memset(b->sum + DEM_BLOCKS/2*b->columns, 0, DEM_BLOCKS/2*b->columns*sizeof *b->sum);
    b->full = DEM_BLOCKS/2;
    b->length *= 2;
}

void dem_blocks_add(struct dem_blocks *b, const double *sample)
{
    if (b->full == DEM_BLOCKS)
    {
        merge(b);
    }
    double *const block = b->sum + (size_t)b->full*b->columns;

    for (size_t c = 0; c < b->columns; c++)
    {
        block[c] += sample[c];
        b->total[c] += sample[c];
    }
    b->samples++;
    b->full = (int)(b->samples/b->length);
}

/* Tables of any book. */
double dem_blocks_student(int n)
{
    static const double t[] = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131, 2.120,
                               2.110, 2.101, 2.093, 2.086, 2.080, 2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042, 2.040};

    return t[n - 1];
}

/* Means of a range of columns over all full blocks but `without`; -1: over all samples. */
static void means(const struct dem_blocks *b, size_t first, size_t count, int without, double *mean)
{
    for (size_t c = 0; c < count; c++)
    {
        double sum = 0.0;

        for (int k = 0; k < b->full && without >= 0; k++)
        {
            sum += k == without ? 0.0 : b->sum[(size_t)k*b->columns + first + c];
        }
        mean[c] = without >= 0 ? sum/(double)((b->full - 1)*b->length)
                : b->samples ? b->total[first + c]/(double)b->samples : 0.0;
    }
}

void dem_blocks_derive(const struct dem_blocks *b, size_t first, size_t count, dem_blocks_of *f, int results, double *value,
                       double *ci)
{
    double mean[DEM_BLOCKS_COLUMNS], part[DEM_BLOCKS][DEM_BLOCKS_RESULTS];
    const int n = b->full;

    means(b, first, count, -1, mean);
    f(mean, value);
    for (int k = 0; k < n && n >= DEM_BLOCKS_LEAST; k++)
    {
        means(b, first, count, k, mean);
        f(mean, part[k]);
    }
    for (int r = 0; r < results; r++)
    {
        double middle = 0.0, square = 0.0;

        for (int k = 0; k < n && n >= DEM_BLOCKS_LEAST; k++)
        {
            middle += part[k][r]/(double)n;
        }
        for (int k = 0; k < n && n >= DEM_BLOCKS_LEAST; k++)
        {
            square += (part[k][r] - middle)*(part[k][r] - middle);
        }
        ci[r] = n >= DEM_BLOCKS_LEAST ? dem_blocks_student(n - 1)*sqrt(square*(double)(n - 1)/(double)n) : NAN;
    }
}
