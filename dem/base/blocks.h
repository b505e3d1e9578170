/*
 * blocks.h -- means of many time series at once, and how sure they are: 95 % intervals from blocks of time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Samples that follow each other closely are alike, so their scatter says little about the error of their mean. The sums
 * of samples are kept in blocks; when all blocks are full, neighbours are merged and blocks last twice as long: at the
 * end there are 16 to 32 of them, whatever the length of the run. A quantity f of the means (a ratio, a variance) has
 * the interval t s/sqrt(n) with s from the jackknife: f of all blocks but one, each in turn. It holds when a block is
 * longer than the memory of what is measured. After Flyvbjerg and Petersen, J. Chem. Phys. 91 (1989) 461, and Efron,
 * "The Jackknife, the Bootstrap and Other Resampling Plans", 1982.
 *
 *     struct dem_blocks b;
 *     DEM_TRY(dem_blocks_init(&b, columns));
 *     dem_blocks_add(&b, sample);                           columns numbers; often
 *     dem_blocks_derive(&b, first, count, f, results, value, ci);
 */
#ifndef DEM_BASE_BLOCKS_H
#define DEM_BASE_BLOCKS_H

#include <stddef.h>
#include <stdint.h>

enum
{
    DEM_BLOCKS = 32,                                          /* at most; even */
    DEM_BLOCKS_LEAST = 4,                                     /* fewer full blocks give no interval */
    DEM_BLOCKS_COLUMNS = 32,                                  /* most columns that one f sees */
    DEM_BLOCKS_RESULTS = 16                                   /* most results of one f */
};

struct dem_blocks
{
    size_t columns;
    int64_t samples;                                          /* of all time */
    int64_t length;                                           /* samples in a full block */
    int full;                                                 /* full blocks; the next one is being filled */
    double *sum;                                              /* DEM_BLOCKS x columns */
    double *total;                                            /* columns: of all samples */
};

/* columns numbers a sample. Owns its arrays. */
int dem_blocks_init(struct dem_blocks *, size_t columns);
void dem_blocks_free(struct dem_blocks *);

void dem_blocks_add(struct dem_blocks *, const double *sample);

/* Results of the means of some columns; finite, also when all means are 0. */
typedef void dem_blocks_of(const double *mean, double *result);

/* value[k] and half the width of its 95 % interval, ci[k], of `results` results of f, which sees the means of the
   columns first .. first + count. ci is not-a-number with fewer than DEM_BLOCKS_LEAST full blocks. No samples: all 0. */
void dem_blocks_derive(const struct dem_blocks *, size_t first, size_t count, dem_blocks_of *f, int results, double *value,
                       double *ci);

/* Two-sided 95 % point of Student's distribution with n degrees of freedom, n = 1 .. 31. */
double dem_blocks_student(int n);

#endif
