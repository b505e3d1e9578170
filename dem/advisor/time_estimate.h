/*
 * time_estimate.h -- memory of a run by counting bytes; processor time by running a sample block.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_ADVISOR_TIME_ESTIMATE_H
#define DEM_ADVISOR_TIME_ESTIMATE_H

#include "ranks/dem_state.h"
#include "records/inventory.h"

struct dem_memory_need                                           /* bytes, between rebuilds */
{
    /* of each, as the interaction table requires */
    double particle, pair, row;
    /* of all particles, as a dense bed on one rank */
    double bed;
    double copy;                                          /* of the backup of that bed (lastGood) */
};

/* Listed pairs and candidate contacts per particle of a dense bed with the present skins. */
void dem_memory_need_lists(const struct dem_state *, const struct dem_inventory *, double *pairs,
                           double *rows);

/* Bytes per particle, pair and candidate contact, and of a dense bed. */
void dem_memory_need_count(const struct dem_state *, const struct dem_inventory *,
                           struct dem_memory_need *);

struct dem_step_cost    /* s of processor time for one particle of a dense bed */
{
    double step;                                          /* a step without list updates */
    /* rebuild of the pair list; pruning to candidate contacts */
    double rebuild, prune;
    int64_t particles;                                    /* in the block that was run */
};

/* Collective: each rank runs its own block; the result is the time of the slowest rank. The
   simulation is not changed. Returns DEM_OK or an error. */
int dem_step_cost_measure(const struct dem_state *, const struct dem_inventory *, double dt,
                          struct dem_step_cost *);

#endif
