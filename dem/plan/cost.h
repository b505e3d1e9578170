/*
 * cost.h -- what a run takes: bytes by counting, processor time by running a block of the same physics for a moment.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_PLAN_COST_H
#define DEM_PLAN_COST_H

#include "step/parts.h"
#include "step/survey.h"

struct dem_need                                           /* bytes, between rebuilds */
{
    double particle, pair, row;                           /* of each: what the recipe needs */
    double bed;                                           /* of all particles as a dense bed on one rank */
    double copy;                                          /* of that bed's state, kept for the case that the run fails */
};

/* How many lists a particle of a dense bed has at these skins. */
void dem_need_lists(const struct dem_parts *, const struct dem_survey *, double *pairs, double *rows);

void dem_need_count(const struct dem_parts *, const struct dem_survey *, struct dem_need *);

struct dem_pace                                           /* s of processor time for one particle of a dense bed */
{
    double step;                                          /* with standing lists */
    double renew, prune;                                  /* the lists found anew, or pruned */
    int64_t particles;                                    /* in the block that was run */
};

/* Collective, though each rank runs its own block; the slowest rank's pace. The state is not touched. */
int dem_pace_take(const struct dem_parts *, const struct dem_survey *, double dt, struct dem_pace *);

#endif
