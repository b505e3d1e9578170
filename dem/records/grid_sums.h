/*
 * grid_sums.h -- sums over the particles in the cells of a grid, sampled and averaged over time;
 * the same bits on any number of ranks.
 *
 * A set of columns (struct dem_grid_columns) gives numbers of each particle. A sample distributes
 * them over the cells that the particle overlaps, as integers, so that the sum over particles and
 * ranks does not depend on the order, and adds the sums to block sums (core/block_means.h) on the
 * first rank.
 *
 * The fraction of a particle that belongs to a cell is the product of its fractions in three slabs,
 * each the volume of a sphere between two parallel planes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/block_means.h"
#include "records/averages_io.h"

struct dem_state;

enum
{
    DEM_GRID_COLUMNS = 17,    /* limit of a set */
    DEM_GRID_KINDS = 5
};

struct dem_grid_columns       /* the numbers of a set */
{
    int columns, kinds;
    const int *kind_of;       /* of each column: columns of one unit have one scale, */
    const char *const *kind_name, *const *kind_unit;    /* name and unit in error messages */
    const double *virial;     /* J, of each particle: xx yy zz xy yz zx; NULL: none */
    int scalar;               /* index of a particle scalar */
    void (*values)(const struct dem_grid_columns *, const struct dem_state *, size_t particle,
                   double *out);
};

struct dem_grid_sums          /* accumulators of a set */
{
    int columns;              /* in a cell */
    int64_t *sum;
    double *sample;
    struct dem_block_means blocks;    /* on the first rank */
};

size_t dem_averages_cells(const struct dem_averages_entry *);

/* Only the rank with `collects` (the first) allocates block sums. */
int dem_grid_sums_init(struct dem_grid_sums *, const struct dem_averages_entry *, int columns,
                       int collects);
void dem_grid_sums_free(struct dem_grid_sums *);

/* Collective. Add a sample of the first n particles of this rank. Returns `status`; when that is
   DEM_OK, DEM_ERROR_NUMBER on the rank of a particle whose numbers are too large. All ranks skip such
   a sample. */
int dem_grid_sums_sample(struct dem_grid_sums *, const struct dem_averages_entry *,
                         const struct dem_grid_columns *, const struct dem_state *, size_t n,
                         int status);
