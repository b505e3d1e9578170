/*
 * neighbor_rebuild.h -- rebuild and prune the neighbor lists.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"

/* Collective. Rebuild at the present positions: order of particles, ghosts, pairs, contact rows and
   their history. */
int dem_neighbor_rebuild(struct dem_state *);

/* Collective. Contact rows from the pairs of the outer list that are within the inner skin;
   `rebuilt`: with the history saved before a rebuild. */
int dem_neighbor_prune(struct dem_state *, int rebuilt);

/* Collective, after dem_neighbor_check_particles. Remove and insert the particles that leave and
   enter in this step, without new lists. The host's lists are not valid afterwards (DEM_NEIGHBORS_NONE). */
int dem_neighbor_change_particles(struct dem_state *);

/* 1 in a step in which particles that have left the domain are removed. */
int dem_neighbor_removal_is_due(const struct dem_state *);

/* Collective. `removes`: 1 on all ranks when any particle has to be removed now. */
int dem_neighbor_check_removals(struct dem_state *, int *removes);
