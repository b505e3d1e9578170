/*
 * lost_particles.h -- particles that were removed from the run or crossed a wall: recorded by each
 * rank, collected from all ranks.
 *
 * The cause of each loss is composed in lost_cause.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_types.h"
#include "ranks/decomposition.h"
#include "particles/particles.h"

struct dem_lost_particles
{
    size_t n, capacity, crossed_capacity;
    struct dem_loss *loss;  /* of this rank, not yet collected */
    struct dem_loss *all;   /* of all ranks, as collected last */
    int64_t passages;          /* through walls, of this rank, in this run */
    size_t crossings;
    uint32_t *crossed;         /* contact rows whose particle crossed its wall in this sweep */
};

void dem_lost_particles_free(struct dem_lost_particles *);

/* Record a particle in its present state at a time [s]. `removed`: 0 when it stays in the run. */
int dem_lost_particles_add(struct dem_lost_particles *, const struct dem_particle *, double time,
                           int removed, const char *cause);

/* Collective. Collect what all ranks have recorded since the last call in `all` of every rank,
   sorted by time and id. */
int dem_lost_particles_collect(struct dem_lost_particles *, const struct dem_decomposition *,
                               int64_t *n);
