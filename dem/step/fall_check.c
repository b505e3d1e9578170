/*
 * fall_check.c -- count the particles that fell through walls, and end the run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/fall_check.h"
#include "core/error.h"
#include "records/lost_particles.h"
#include "ranks/collect.h"

static const int64_t min_passages = 10;
static const double max_passages = 0.01;     /* of the particles */

int dem_fall_check(const struct dem_state *state)
{
    int64_t counted[2] = {state->lost_particles->passages, (int64_t)state->particles.n};

    if (dem_walls_count_triangles(&state->walls) == 0)
    {
        return DEM_OK;
    }
    dem_collect_sum_int64(&state->decomposition, counted, 2);
    DEM_REQUIRE(
        counted[0] <= min_passages || (double)counted[0] <= max_passages*(double)counted[1],
        DEM_ERROR_LOST,
        "%lld passages of %lld particles through walls until time %g s, the limit is %lld or %g %%: the walls do not hold them, "
        "see lost.csv for where and why; use a stiffer material, or a smaller time/step",
        (long long)counted[0], (long long)counted[1], state->time, (long long)min_passages,
        100.0*max_passages);
    return DEM_OK;
}
