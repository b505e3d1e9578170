/*
 * block_means.c -- block sums whose length doubles, and the delete-one jackknife over the blocks.
 *
 * When all DEM_BLOCK_MEANS_MAX_BLOCKS blocks are full, neighbouring blocks are merged in pairs, so
 * that half of them are in use again and each new block holds twice as many samples.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/block_means.h"
#include "core/error.h"
#include "core/memory.h"
#include <math.h>
#include <string.h>

int dem_block_means_init(struct dem_block_means *b, size_t columns)
{
    *b = (struct dem_block_means){.columns = columns, .length = 1};
    DEM_TRY(DEM_NEW(b->sum, DEM_BLOCK_MEANS_MAX_BLOCKS*columns));
    return DEM_NEW(b->total, columns);
}

void dem_block_means_free(struct dem_block_means *b)
{
    dem_memory_free(b->sum);
    dem_memory_free(b->total);
    *b = (struct dem_block_means){.columns = 0};
}

/* Add each pair of neighbouring blocks into one of twice the length. */
static void merge_blocks(struct dem_block_means *b)
{
    for (size_t k = 0; k < DEM_BLOCK_MEANS_MAX_BLOCKS/2; k++)
    {
        b->weight[k] = b->weight[2*k] + b->weight[2*k + 1];
        for (size_t c = 0; c < b->columns; c++)
        {
            b->sum[k*b->columns + c] =
                b->sum[2*k*b->columns + c] + b->sum[(2*k + 1)*b->columns + c];
        }
    }
    memset(b->weight + DEM_BLOCK_MEANS_MAX_BLOCKS/2, 0,
           DEM_BLOCK_MEANS_MAX_BLOCKS/2*sizeof *b->weight);
    memset(b->sum + DEM_BLOCK_MEANS_MAX_BLOCKS/2*b->columns, 0,
           DEM_BLOCK_MEANS_MAX_BLOCKS/2*b->columns*sizeof *b->sum);
    b->full = DEM_BLOCK_MEANS_MAX_BLOCKS/2;
    b->length *= 2;
}

void dem_block_means_add(struct dem_block_means *b, const double *sample, double weight)
{
    if (b->full == DEM_BLOCK_MEANS_MAX_BLOCKS)
    {
        merge_blocks(b);
    }
    double *const block = b->sum + (size_t)b->full*b->columns;

    for (size_t c = 0; c < b->columns; c++)
    {
        block[c] += weight*sample[c];
        b->total[c] += weight*sample[c];
    }
    b->weight[b->full] += weight;
    b->total_weight += weight;
    b->samples++;
    b->full = (int)(b->samples/b->length);
}

void dem_block_means_restore(struct dem_block_means *b, int64_t samples, int64_t length)
{
    b->samples = samples;
    b->length = length;
    b->full = (int)(samples/length);
    b->total_weight = (double)samples;
    for (int k = 0; k < DEM_BLOCK_MEANS_MAX_BLOCKS; k++)
    {
        b->weight[k] = k < b->full ? (double)length : k == b->full ? (double)(samples%length) : 0.0;
    }
}

/* Two-sided 95 % points for n = 1 .. 31, from the standard table. */
double dem_block_means_student_t95(int n)
{
    static const double t[] = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306,
                               2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131, 2.120,
                               2.110, 2.101, 2.093, 2.086, 2.080, 2.074, 2.069, 2.064,
                               2.060, 2.056, 2.052, 2.048, 2.045, 2.042, 2.040};

    return t[n - 1];
}

/* Means of columns first .. first + count over all full blocks except `without`; -1: over all
   samples. */
static void column_means(const struct dem_block_means *b, size_t first, size_t count, int without,
                         double *mean)
{
    for (size_t c = 0; c < count; c++)
    {
        double sum = 0.0, weight = 0.0;

        for (int k = 0; k < b->full && without >= 0; k++)
        {
            sum += k == without ? 0.0 : b->sum[(size_t)k*b->columns + first + c];
            weight += k == without ? 0.0 : b->weight[k];
        }
        mean[c] = without >= 0 ? sum/weight
                : b->samples ? b->total[first + c]/b->total_weight : 0.0;
    }
}

void dem_block_means_derive(const struct dem_block_means *b, size_t first, size_t count,
                            dem_block_means_function *f, int results, double *value, double *ci)
{
    double mean[DEM_BLOCK_MEANS_MAX_COLUMNS];
    double left_out[DEM_BLOCK_MEANS_MAX_BLOCKS][DEM_BLOCK_MEANS_MAX_RESULTS];
    const int n = b->full;

    column_means(b, first, count, -1, mean);
    f(mean, value);
    for (int k = 0; k < n && n >= DEM_BLOCK_MEANS_MIN_BLOCKS; k++)
    {
        column_means(b, first, count, k, mean);
        f(mean, left_out[k]);
    }
    for (int r = 0; r < results; r++)
    {
        double centre = 0.0, square = 0.0;

        for (int k = 0; k < n && n >= DEM_BLOCK_MEANS_MIN_BLOCKS; k++)
        {
            centre += left_out[k][r]/(double)n;
        }
        for (int k = 0; k < n && n >= DEM_BLOCK_MEANS_MIN_BLOCKS; k++)
        {
            square += (left_out[k][r] - centre)*(left_out[k][r] - centre);
        }
        ci[r] = n >= DEM_BLOCK_MEANS_MIN_BLOCKS
                  ? dem_block_means_student_t95(n - 1)*sqrt(square*(double)(n - 1)/(double)n)
                  : NAN;
    }
}
