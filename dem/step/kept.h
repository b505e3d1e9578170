/*
 * kept.h -- a copy of the state in memory, for the case that the run fails: particles with their columns, and what
 * contacts remember.
 *
 * Not here: when a copy is made (step.c), where it goes after a failure (dem.h, dem_restore).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_KEPT_H
#define DEM_STEP_KEPT_H

#include "state/contacts.h"
#include "state/particles.h"

struct dem_kept
{
    int64_t every;                                        /* steps between copies within a window; 0: none */
    int held;                                             /* 1: there is a copy */
    int64_t steps;                                        /* of the copy, */
    double time;                                          /* s */
    struct dem_particles particles;                       /* owned ones; no room to reorder them */
    struct dem_contacts rows;                             /* carried ones only */
};

void dem_kept_free(struct dem_kept *);

/* Copy owned particles and all rows with memory. */
int dem_kept_take(struct dem_kept *, const struct dem_particles *, const struct dem_contacts *, const int *wall_region);

/* Put them back; the contacts then have no pairs, and the rows are carried to the next rebuild. */
int dem_kept_give(const struct dem_kept *, struct dem_particles *, struct dem_contacts *);

#endif
