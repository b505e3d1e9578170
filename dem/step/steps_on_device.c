/*
 * steps_on_device.c -- choose the steps that a device makes: nothing reads the state in them, nothing
 * is due, and the lists hold.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/steps_on_device.h"
#include "core/clock.h"
#include "core/error.h"
#include "device/device_steps.h"
#include "ranks/agree.h"
#include "records/grid_averages.h"
#include "records/timers.h"
#include "sources/flows.h"
#include "step/limits.h"
#include "step/neighbor_rebuild.h"
#include "step/neighbor_update.h"
#include <math.h>

enum
{
    MOST_STEPS = 65536,
    FEW_STEPS = 8         /* the state is not moved for fewer; new lists allow more */
};

/* 1 when something reads the forces or positions of this step, or copies the state in it. */
static int is_read(const struct dem_state *state, int64_t step)
{
    const int64_t number = state->window.steps_before + step;
    const double time = state->window.start + (double)step*state->dt;

    return dem_grid_averages_due(state->averages, time) ||
           (state->backup.every > 0 && number >= state->backup.steps + state->backup.every);
}

/* Particles may enter or leave in steps whose numbers are multiples of this; 0: in none, or the program asks for
   it between windows. */
static int64_t check_steps(const struct dem_state *state)
{
    return (state->flows->n > 0 && !state->flows->asked) || state->domain.remove ? DEM_FLOW_STEPS : 0;
}

static void end_check(struct dem_state *state)
{
    if (dem_flows_due(state))
    {
        dem_flows_end_check(state);
    }
    state->flows->now = state->flows->left = 0;
    state->flows->checked = state->steps;
}

/* The host makes a step in which particles enter or leave where it has to migrate particles between ranks, and
   where it turns particles or advances their eddies, which new ones do not in this step. */
static int host_changes(const struct dem_state *state)
{
    return state->decomposition.ranks > 1 || dem_column(&state->particles, DEM_COLUMN_ORIENTATION) ||
           dem_column(&state->particles, DEM_COLUMN_EDDY);
}

static int enter_or_leave(struct dem_state *state, int *changes, int *end)
{
    DEM_TRY(dem_neighbor_check_particles(state, changes));
    if (!*changes)
    {
        end_check(state);
    }
    *end = state->flows->found = *changes && host_changes(state);
    *changes &= !*end;
    return DEM_OK;
}

static int change(struct dem_state *state)
{
    DEM_TRY(dem_neighbor_change_particles(state));
    end_check(state);
    return DEM_OK;
}

/* last: 1 when the device may make the last step of the window, too. */
static int64_t count_steps(const struct dem_state *state, int64_t first, int last)
{
    int64_t n = 0;

    while (n < MOST_STEPS && first + n < state->window.steps && !is_read(state, first + n))
    {
        n++;
    }
    return n + (last && n < MOST_STEPS && first + n == state->window.steps);
}

/* Displacement [m] by which a particle may move until the first list is used up
   (neighbor_update.c). */
static double rest_of_list(const struct dem_state *state, enum dem_list list)
{
    const struct dem_displacement *const d = &state->pairs.displacement[list];
    const double wall = dem_walls_max_displacement(&state->walls, list, d->centre);

    return fmin(0.5*d->skin, d->skin - wall) - d->spread;
}

static double rest_of_lists(const struct dem_state *state)
{
    return fmin(rest_of_list(state, DEM_LIST_OUTER), rest_of_list(state, DEM_LIST_INNER));
}

/* Between batches of steps: reports progress; ends when a rank has a request to stop. */
static int ends(struct dem_state *state, int64_t made, int *end)
{
    double stop = state->stop_request && *state->stop_request ? 1.0 : 0.0;

    struct dem_progress *const q = &state->progress;
    const double now = q->report ? dem_clock_wall() : 0.0;

    if (q->report && now - q->last >= q->seconds)
    {
        q->last = now;
        q->report(q->self, state->time + (double)made*state->dt, state->steps + made);
    }
    DEM_TRY(dem_agree_max(state, DEM_OK, &stop, 1));
    *end = stop > 0.0;
    return DEM_OK;
}

/* The host counts the steps, and the displacements of all drifts but the last: it counts that one
   itself, in the next step. When the device has stopped for the lists, they are measured there. */
static void count_made(struct dem_state *state, const struct dem_device_steps *steps)
{
    const int64_t more = steps->made - 1;
    double last = 0.0;

    for (int64_t k = 0; k < steps->made; k++)
    {
        last = steps->speed[k]*state->dt;
        for (int l = 0; l < DEM_LISTS && k < more; l++)
        {
            state->pairs.displacement[l].spread += last;
        }
        if (k < more)
        {
            (void)dem_skins_step(&state->pairs.skins, last);
        }
    }
    for (enum dem_list l = 0; l < DEM_LISTS; l++)
    {
        struct dem_displacement *const d = &state->pairs.displacement[l];

        d->spread = steps->made < steps->most && rest_of_list(state, l) < 2.0*last
                        ? fmax(d->spread, d->skin)
                        : d->spread;
    }
    state->steps += more;
    state->time = state->window.start + (double)(steps->first + more)*state->dt;
    state->timers->steps += more;
    state->timers->particle_steps += more*(int64_t)state->particles.n;
    for (int c = 0; c < state->contacts.rows.classes; c++)
    {
        state->timers->row_steps += more*dem_device_rows_of(state->device, c);
    }
    state->next_drift.done = state->next_drift.counted = !state->contacts_on_device;
    state->next_drift.max_speed = steps->speed[steps->made - 1];
}

/* lists: 1 when the device has made lists, so that the host has to make new ones for its next step. */
static int make_steps(struct dem_state *state, int64_t first, int64_t *made, int *lists)
{
    const int last = dem_device_makes_last_step(state) &&
                     !dem_grid_averages_due(state->averages, state->window.start + state->window.length);
    struct dem_device_steps steps = {.first = first, .last = last ? state->window.steps : 0};
    /* the largest speed of this rank; whether a program adds forces on it */
    double max[2] = {state->next_drift.max_speed, state->applied_forces.program.add ? 1.0 : 0.0};

    /* some of what refusal.c names can begin after the device was opened */
    if (dem_device_waits(state) || state->window.stopped || state->walls.following > 0)
    {
        return DEM_OK;
    }
    steps.most = count_steps(state, first, last);
    const int enough = steps.most >= (state->contacts_on_device ? 1 : FEW_STEPS);

    DEM_TRY(enough ? dem_agree_max(state, DEM_OK, max, 2) : DEM_OK);
    if (!enough || max[1] > 0.0)
    {
        return DEM_OK;
    }
    dem_device_set_skins(state, max[0]);
    steps.rest = rest_of_lists;
    steps.ends = ends;
    steps.check = check_steps(state);
    steps.enter_or_leave = enter_or_leave;
    steps.change = change;
    steps.max_displacement = dem_limits_max_wall_displacement(state);
    steps.max_speed = dem_limits_max_speed(state);
    dem_timers_begin_rare_phase(state->timers, DEM_PHASE_REFRESH);
    const int status = dem_device_advance(state, &steps);

    dem_timers_end_rare_phase(state->timers, DEM_PHASE_DEVICE);
    DEM_TRY(status);
    if (steps.made > 0)
    {
        count_made(state, &steps);
    }
    *made = steps.made;
    *lists = steps.lists;
    return DEM_OK;
}

int dem_steps_on_device(struct dem_state *state, int64_t first, int64_t *made)
{
    int lists = 0;

    *made = 0;
    DEM_TRY(make_steps(state, first, made, &lists));
    return *made == 0 && (lists || state->contacts_on_device) ? dem_neighbor_take_back(state) : DEM_OK;
}
