/*
 * inlet_walls.h -- the triangles near an inlet on every rank, so that all ranks make the same trials.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"

struct dem_inlet_walls
{
    const struct dem_walls *walls;
    struct dem_wall_search *search;
    struct dem_walls near;               /* with several ranks the first two point to these */
    struct dem_wall_search near_search;
};

/* Collective; a rank that has failed before (`status`) takes part. The walls within `reach` [m] of
   a box; dem_inlet_walls_free comes after it, also when it has failed. */
int dem_inlet_walls_gather(struct dem_inlet_walls *, struct dem_state *, int status,
                           double box[2][3], double reach);
void dem_inlet_walls_free(struct dem_inlet_walls *);
