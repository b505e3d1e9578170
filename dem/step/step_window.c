/*
 * step_window.c -- the steps of a coupling window: half a kick at its start, the steps, and what ends it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/step_window.h"
#include "core/clock.h"
#include "device/device_steps.h"
#include "particles/scalars.h"
#include "ranks/agree.h"
#include "records/energy_balance.h"
#include "records/timers.h"
#include "records/wall_statistics.h"
#include "sources/flows.h"
#include "step/body_window.h"
#include "step/clump_batch.h"
#include "step/clump_heat.h"
#include "step/step.h"
#include "step/wall_bodies.h"

/* The first half kick of a window, or the rest of it. */
static int first_kick(struct dem_state *state, double kick)
{
    if (state->contacts_on_device)
    {
        DEM_TRY(dem_agree(state, dem_device_kick_walls(state, kick)));
    }
    if (kick > 0.0)
    {
        if (!state->contacts_on_device)
        {
            dem_wall_statistics_add_kick(state, kick);
        }
        if (state->walls.bodies > 0)
        {
            dem_wall_bodies_kick(state, kick);
        }
        const struct dem_body_sweep sweep = dem_step_sweep(state, kick, 0.0);

        dem_sweep_bodies(&state->particles, &state->interaction_table.bodies, &sweep);
        if (state->clumps.n > 0)
        {
            (void)dem_kick_clumps(state, &state->particles, &sweep);
        }
    }
    dem_domain_constrain(&state->domain, &state->particles);
    dem_timers_end_phase(state->timers, DEM_PHASE_BODIES);
    return DEM_OK;
}

/* The clock is read once in 16 steps. */
static void tell_progress(struct dem_state *state)
{
    struct dem_progress *const q = &state->progress;

    if (q->report && (state->steps%16 == 0 || state->device))
    {
        const double now = dem_clock_wall();

        if (now - q->last >= q->seconds)
        {
            q->last = now;
            q->report(q->self, state->time, state->steps);
        }
    }
}

/* The remaining steps of the window, or those until a stop is requested. */
static int make_steps(struct dem_state *state)
{
    int status = DEM_OK;

    state->window.stopped = state->window.half_step_ahead = state->next_drift.done = 0;
    state->next_drift.counted = 0;
    for (int64_t k = state->steps - state->window.steps_before + 1;
         k <= state->window.steps && !state->window.stopped;
         k++)
    {
        const double since = state->time;

        state->time = state->window.start + (double)k*state->dt;
        DEM_TRY(dem_step(state, since, &k, &status));
        tell_progress(state);
    }
    return dem_agree(state, status);
}

/* The same, and what ends the window. */
static int finish_window(struct dem_state *state)
{
    const int status = make_steps(state);

    dem_clumps_store(&state->clumps, &state->particles);
    DEM_TRY(status);
    state->window.half_step_ahead = state->steps - state->window.steps_before < state->window.steps;
    if (!state->window.half_step_ahead)
    {
        dem_clump_flow_end_window(&state->clumps, &state->particles);
        dem_bodies_end_window(&state->particles, &state->domain, state->window.length);
        if (state->clumps.heat)
        {
            dem_clump_heat_end_window(&state->clumps, &state->interaction_table, &state->particles);
        }
        dem_scalars_end_window(&state->particles, &state->interaction_table);
    }
    dem_timers_end_advance(state->timers);
    return DEM_OK;
}

/* Particles may have been loaded, restored or removed since the last window. */
static int index_clumps(struct dem_state *state)
{
    return dem_column(&state->particles, DEM_COLUMN_CLUMP)
               ? dem_agree(state, dem_index_clumps(state))
               : DEM_OK;
}

int dem_step_window(struct dem_state *state, double dt, int64_t steps)
{
    /* s  an open window has left velocities ahead by this */
    const double done = state->window.half_step_ahead ? 0.5*state->dt : 0.0;

    state->window.length = dt*(double)steps;
    state->dt = dt;
    state->window.start = state->time;
    state->window.steps_before = state->steps;
    state->window.steps = steps;
    dem_timers_begin_advance(state->timers, state->particles.n);
    DEM_TRY(index_clumps(state));
    dem_walls_move(&state->walls, state->time, 0.0);
    dem_walls_begin_advance(&state->walls, state->window.length);
    dem_bodies_begin_window(&state->particles, &state->interaction_table.bodies);
    dem_scalars_begin_window(&state->particles, &state->interaction_table);
    if ((state->particles.ghost_window.n > 0 ||
         dem_column(&state->particles, DEM_COLUMN_ADDED_MASS)) &&
        state->lists_state == DEM_NEIGHBORS_VALID)
    {
        DEM_TRY(dem_halo_refresh_window(&state->halo, &state->particles));
    }
    dem_flows_complete_departures(state->flows, 0.5*dt - done);
    if (state->applied_forces.program.add)
    {
        DEM_TRY(dem_agree(state, dem_step_ask_for_forces(state)));
    }
    DEM_TRY(first_kick(state, 0.5*dt - done));
    return finish_window(state);
}

int dem_step_continue(struct dem_state *state)
{
    dem_timers_begin_advance(state->timers, state->particles.n);
    DEM_TRY(index_clumps(state));
    return finish_window(state);
}
