/*
 * flow_passages.c -- count the particles that have passed planes since the last check.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/flows.h"
#include "core/error.h"
#include "ranks/agree.h"
#include "ranks/dem_state.h"
#include <stdlib.h>

static int count_particle(struct dem_state *state, size_t i, double late)
{
    const struct dem_streams *const plan = state->flows->plan;
    int passed[DEM_SNAPSHOT_FLOWS];
    const int known = dem_flows_planes_passed(state, i, passed);

    for (int k = 0; known && k < plan->planes; k++)
    {
        const int flow = plan->streams + plan->outlets + 2*k + (passed[k] < 0);

        for (int n = abs(passed[k]); n > 0; n--)
        {
            DEM_TRY(dem_flows_record_departure(state, flow, &state->particles.record[i], late));
        }
    }
    return DEM_OK;
}

int dem_flows_count_passages(struct dem_state *state, double late)
{
    int status = DEM_OK;

    if (state->flows->n == 0 || state->flows->plan->planes == 0)
    {
        return DEM_OK;
    }
    for (size_t i = 0; i < state->particles.n && !status; i++)
    {
        status = count_particle(state, i, late);
    }
    DEM_TRY(dem_agree(state, status));
    return dem_flows_sum_departures(state);
}
