/*
 * insert_amount.h -- the number of particles of a group of `insert`, and their diameters.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "sources/insert_group.h"
#include "sources/size_distribution.h"

/* particles of one group: every rank stores all diameters */
static const double dem_amount_max = 1e8;

struct dem_amount
{
    int64_t count;   /* 0: draw until the volume is reached; both 0: nothing given */
    double volume;   /* m3 */
    char what[160];  /* the entry and its value, for messages */
};

/* Read the amount of a group. `mean` is the mean volume of a particle [m3], from which the
   number is estimated and limited. */
int dem_amount_read(struct dem_amount *, const struct dem_insert_group *,
                    const struct dem_interaction_table *, double mean);

/* Draw the diameters of the group until the amount is reached; with one diameter, compute the
   count. */
int dem_amount_draw(struct dem_insert_group *, const struct dem_amount *,
                    const struct dem_size_distribution *);
