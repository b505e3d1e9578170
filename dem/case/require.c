/*
 * require.c -- what the public calls require: a sound state, counts, agreement of ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "core/error.h"
#include "ranks/collect.h"
#include <math.h>

int dem_sim_require_sound(const struct dem *d, const char *call)
{
    DEM_REQUIRE(!d->failed, DEM_ERROR_STATE, "%s after a dem_advance that failed, which has left "
                "particles in the middle of a step; go back to the last good state with dem_restore "
                "(dem_backup_every makes it), or load the last snapshot; in Python: create another "
                "Simulation(scene, start=\"saved.dem\") from a file of sim.save", call);
    return DEM_OK;
}

int dem_sim_require_count(const char *call, const char *items, int64_t n)
{
    DEM_REQUIRE(n >= 0, DEM_ERROR_INPUT, "%s: %lld %s; give 0 or more", call, (long long)n, items);
    /* 128 bytes an item or less */
    DEM_REQUIRE(n < INT64_MAX/128, DEM_ERROR_MEMORY, "%s: %lld %s are more than memory can hold",
                call, (long long)n, items);
    return DEM_OK;
}

int dem_sim_agree(const struct dem *d, int status)
{
    return dem_collect_agree(&d->state.decomposition, status);
}

int dem_sim_gather(const struct dem_state *state, int status, size_t size, size_t n, const double *mine,
                   double **items, size_t *number)
{
    const struct dem_collect_items own = {"triangles of a wall or patch (make it of several)", mine,
                                          n, size*sizeof *mine};
    void *all;

    DEM_TRY(dem_collect_gather(&state->decomposition, status, &own, &all, number));
    *items = all;
    return DEM_OK;
}

double dem_sim_max_radius(const struct dem *d)
{
    double max = 0.0;

    for (int m = 0; m < DEM_MATERIALS; m++)
    {
        max = fmax(max, d->state.interaction_table.max_radius[m]);
    }
    return max;
}
