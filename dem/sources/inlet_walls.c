/*
 * inlet_walls.c -- gather the triangles near an inlet from all ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/inlet_walls.h"
#include "core/error.h"

int dem_inlet_walls_gather(struct dem_inlet_walls *i, struct dem_state *state, int status,
                           double box[2][3], double reach)
{
    *i = (struct dem_inlet_walls){.walls = &state->walls, .search = &state->pairs.wall_search};
    if (state->decomposition.ranks == 1 || dem_walls_count_triangles(&state->walls) == 0)
    {
        return status;
    }
    i->walls = &i->near;
    i->search = &i->near_search;
    DEM_TRY(dem_wall_store_gather(&state->wall_store, status, &state->walls, &state->domain, box, reach,
                                  &i->near));
    return dem_wall_search_prepare(&i->near_search, &i->near, state->pairs.wall_search.radius);
}

void dem_inlet_walls_free(struct dem_inlet_walls *i)
{
    dem_walls_free_part(&i->near);
    dem_wall_search_free(&i->near_search);
}
