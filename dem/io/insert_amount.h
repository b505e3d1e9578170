/*
 * insert_amount.h -- how many particles a group of `insert` has, and how wide each is.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_INSERT_AMOUNT_H
#define DEM_IO_INSERT_AMOUNT_H

#include "io/insert_batch.h"
#include "io/sizes.h"

static const double dem_amount_most = 1e8;                /* particles of one group: every rank knows the diameters of all */

struct dem_amount
{
    int64_t count;                                        /* 0: until the volume is reached; both 0: nothing is said */
    double volume;                                        /* m3 */
    char what[160];                                       /* how that was asked for, for messages */
};

/* `mean` is the volume [m3] of a particle in the mean, which tells how many will be drawn before the first is. */
int dem_amount_read(struct dem_amount *, const struct dem_batch *, const struct dem_recipe *, double mean);

/* Draw diameters until there are enough; where all are equal, count them. */
int dem_amount_draw(struct dem_batch *, const struct dem_amount *, const struct dem_sizes *);

#endif
