/*
 * block_means.h -- means of many time series at once, with 95 % confidence intervals from block
 * sums.
 *
 * Consecutive samples are correlated, so their scatter says little about the error of their mean.
 * The sums of samples are stored in blocks of equal length. When all blocks are full, neighbours
 * are merged and blocks become twice as long: at the end there are 16 to 32 of them, whatever the
 * length of the run. The 95 % half width of a quantity f of the means (a ratio, a variance) is
 *
 *     ci = t s/sqrt(n)
 *
 * with n the number of full blocks, t Student's 95 % point for n - 1 degrees of freedom and s from
 * the jackknife: f of all blocks except one, each in turn. Valid when a block is longer than the
 * correlation time of the quantity.
 *
 * Sources: Flyvbjerg and Petersen, J. Chem. Phys. 91 (1989) 461; Efron, "The Jackknife, the
 * Bootstrap and Other Resampling Plans", 1982.
 *
 *     struct dem_block_means b;
 *     DEM_TRY(dem_block_means_init(&b, columns));
 *     dem_block_means_add(&b, sample, weight);              `columns` numbers; once a sample
 *     dem_block_means_derive(&b, first, count, f, results, value, ci);
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_types.h"

#include <stddef.h>
#include <stdint.h>

enum
{
    DEM_BLOCK_MEANS_MAX_BLOCKS = 32,   /* limit of blocks; even */
    DEM_BLOCK_MEANS_MIN_BLOCKS = DEM_MEANS_MIN_BLOCKS,    /* fewer full blocks give no interval */
    DEM_BLOCK_MEANS_MAX_COLUMNS = 32,  /* limit of columns that one f sees */
    DEM_BLOCK_MEANS_MAX_RESULTS = 16   /* limit of results of one f */
};

struct dem_block_means
{
    size_t columns;
    int64_t samples;  /* number of samples added */
    int64_t length;   /* samples in a full block */
    int full;         /* full blocks; the next one fills */
    double weight[DEM_BLOCK_MEANS_MAX_BLOCKS];  /* sum of weights of each block */
    double total_weight;                        /* and of all samples */
    double *sum;      /* of weight times sample, of each block: blocks x columns */
    double *total;    /* of all samples: columns */
};

/* `columns` numbers a sample. The struct owns its arrays; free them with dem_block_means_free.
   DEM_ERROR_MEMORY when they do not fit. */
int dem_block_means_init(struct dem_block_means *, size_t columns);
void dem_block_means_free(struct dem_block_means *);

/* Add one sample of `columns` numbers, with a weight > 0: 1, or the time that it stands for. */
void dem_block_means_add(struct dem_block_means *, const double *sample, double weight);

/* Set the counts of a struct whose sums are restored; every sample had the weight 1. */
void dem_block_means_restore(struct dem_block_means *, int64_t samples, int64_t length);

/* Results as a function of the means of some columns; must be finite also when all means are 0. */
typedef void dem_block_means_function(const double *mean, double *result);

/* value[k] and the half width of its 95 % interval, ci[k], for the `results` results of f. f gets
   the means of the columns first .. first + count. ci is NaN with fewer than
   DEM_BLOCK_MEANS_MIN_BLOCKS full blocks. Without samples all means are 0. */
void dem_block_means_derive(const struct dem_block_means *, size_t first, size_t count,
                            dem_block_means_function *f, int results, double *value, double *ci);

/* Two-sided 95 % point of Student's t distribution with n degrees of freedom, n = 1 .. 31. */
double dem_block_means_student_t95(int n);
