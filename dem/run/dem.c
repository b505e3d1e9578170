/*
 * dem.c -- the public calls that advance a run, move its walls, and save and restore it.
 *
 * Queries are in query.c, the fluid in fluid_api.c, streams and outlets in inflow_api.c; case/
 * starts the run and frees it. A caller may trap floating-point exceptions (OpenFOAM does); calls
 * that compute hold the traps and restore them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "dem_fluid.h"
#include "core/clock.h"
#include "core/error.h"
#include "core/memory.h"
#include "device/device_steps.h"
#include "records/snapshot.h"
#include "records/energy_balance.h"
#include "records/wall_statistics.h"
#include "records/wall_wear.h"
#include "ranks/agree.h"
#include "run/stage_tests.h"
#include "step/cell_motion.h"
#include "step/fall_check.h"
#include "step/step_window.h"
#include "step/step_backup.h"
#include "step/wall_bodies.h"
#include <fenv.h>
#include <math.h>
#include <string.h>

/* ---- advance --------------------------------------------------------------------------------- */

/* The fluid exerts no force on walls: their weight has no buoyancy against it. */
static int check_weights(const struct dem *d)
{
    const struct dem_walls *const w = &d->state.walls;

    for (int k = 0; k < w->walls && w->bodies > 0 && d->with_fluid; k++)
    {
        const struct dem_wall_body *const b = dem_walls_body(w, k);

        DEM_REQUIRE(!b || b->weighs <= 0.0 || b->weight_given, DEM_ERROR_INPUT,
                    "wall %s has weight in a fluid, which exerts no force on it: no buoyancy, no drag; give weight no "
                    "in its motion, and a force if it has one in the fluid, or weight yes for the full weight",
                    w->wall[k].name);
    }
    return DEM_OK;
}

static int check_fluid(const struct dem *d)
{
    DEM_TRY(dem_require_fluid(d));
    DEM_TRY(check_weights(d));
    DEM_TRY(d->coupled ? dem_sim_agree(d, dem_sim_require_fluid_scalars(d)) : DEM_OK);
    DEM_REQUIRE(!(d->coupled && d->driven), DEM_ERROR_INPUT,
                "there are driven particles, which the balances of a coupled run do not know; make "
                "them frozen, or let a wall move");
    DEM_REQUIRE(!(d->coupled && d->state.applied_forces.n > 0), DEM_ERROR_INPUT,
                "the scene has forces, which the balances of a coupled run do not know; remove "
                "forces, or run the scene by itself");
    DEM_REQUIRE(!(d->coupled && d->state.cell.active), DEM_ERROR_INPUT,
                "domain/cell does not go with a coupled fluid; remove it, or run the scene by itself");
    DEM_REQUIRE(!d->with_fluid || d->scene.fluid.given || d->flow_on_request
                    || d->state.flows->plan->streams == 0,
                DEM_ERROR_STATE,
                "insert/%s inserts particles during an advance, but the coupled fluid knows no new "
                "particle before the next exchange; call dem_case_flows_on_request before dem_start, and "
                "dem_flow_apply between two advances",
                d->state.flows->plan->stream[0].name);
    return DEM_OK;
}

static const double max_steps = 0x1p53;    /* larger whole numbers are not exact in a double */

/* 1 when a window was interrupted and this advance asks for the rest of it: same end, same
   number of steps. */
static int continues_window(const struct dem *d, double duration)
{
    const struct dem_state *const state = &d->state;
    const double rest = state->window.start + state->window.length - state->time;

    return state->window.half_step_ahead && fabs(duration - rest) <= 1e-3*state->dt
        && ceil(state->window.length/d->step*(1.0 - 1e-12)) == (double)state->window.steps;
}

int dem_wall_move(struct dem *d, const char *name, int64_t n, const double *triangles)
{
    struct dem_mesh_wall *wall;

    DEM_TRY(dem_sim_copy_corners(d, "dem_wall_move", name, n, triangles, &wall));
    return dem_sim_move_wall(d, wall, 0);
}

/* One window of equal steps, or the rest of one that was stopped. */
static int advance_window(struct dem *d, double duration)
{
    const int64_t steps = (int64_t)ceil(duration/d->step*(1.0 - 1e-12));

    return continues_window(d, duration)
               ? dem_step_continue(&d->state)
               : dem_step_window(&d->state, duration/(double)(steps > 0 ? steps : 1),
                                 steps > 0 ? steps : 1);
}

int dem_advance(struct dem *d, double duration)
{
    fenv_t caller;

    DEM_TRY(dem_sim_require_sound(d, "dem_advance"));
    DEM_REQUIRE(isgreater(duration, 0.0) && isfinite(duration), DEM_ERROR_INPUT,
                "duration %g s; give a time above 0", duration);
    DEM_TRY(check_fluid(d));
    DEM_REQUIRE(duration < max_steps*d->step, DEM_ERROR_INPUT,
                "%g s at steps of %g s are more than %g steps; give a longer step or a shorter "
                "time",
                duration, d->step, max_steps);
    feholdexcept(&caller);
    int status = d->scene.stages.n > 0 || d->state.walls.passing > 0
                   ? dem_stages_advance(d, duration, advance_window)
                   : advance_window(d, duration);

    status = status ? status : dem_fall_check(&d->state);
    fesetenv(&caller);
    d->failed = status != DEM_OK;
    d->ranks_apart = status != DEM_OK && status != DEM_ERROR_NUMBER && status != DEM_ERROR_LOST;
    return status;
}

void dem_set_stop_flag(struct dem *d, const volatile sig_atomic_t *asked)
{
    d->state.stop_request = asked;
}

void dem_set_progress(struct dem *d, double seconds,
                      void (*report)(void *self, double time, int64_t steps), void *self)
{
    d->state.progress = (struct dem_progress){.report = report,
                                              .self = self,
                                              .seconds = seconds,
                                              .last = dem_clock_wall()};
}

int dem_set_force(struct dem *d, dem_force_function *add, void *self)
{
    DEM_REQUIRE(!d->coupled || !add, DEM_ERROR_STATE, "dem_set_force: the balances of a coupled run "
                "do not know forces of the program");
    d->state.applied_forces.program.add = add;
    d->state.applied_forces.program.self = self;
    return DEM_OK;
}

int dem_stopped(const struct dem *d)
{
    return d->state.window.half_step_ahead ? d->state.window.stopped : 0;
}

int dem_stop_requested(const struct dem *d)
{
    return d->state.window.stopped;
}

/* ---- save and restore ------------------------------------------------------------------------ */

/* The scene goes behind the averages. */
static int add_scene(struct dem *d, struct dem_snapshot_scene *scene, struct dem_span **span, int *n)
{
    size_t capacity = (size_t)*n;

    DEM_TRY(dem_sim_describe_scene(d, scene));
    DEM_TRY(DEM_GROW(*span, capacity, (size_t)*n + DEM_SNAPSHOT_SCENE_SPANS));
    dem_snapshot_scene_spans(scene, *span + *n);
    *n += DEM_SNAPSHOT_SCENE_SPANS;
    return DEM_OK;
}

static int write_snapshot(struct dem *d, const char *path, struct dem_snapshot *s)
{
    struct dem_state *const state = &d->state;
    struct dem_grid_average_record *record = NULL;
    struct dem_snapshot_scene scene = {.text = NULL};
    struct dem_span *span = NULL;
    int status = DEM_OK;

    /* after dem_restore the sums hold later samples */
    if (state->averages->grids > 0 && state->decomposition.rank == 0 && !d->restored)
    {
        status = dem_grid_averages_spans(state->averages, &record, &span, &s->caller_data_count);
    }
    dem_wall_wear_gather(state);
    if (state->decomposition.rank == 0)
    {
        status = status ? status : add_scene(d, &scene, &span, &s->caller_data_count);
    }
    status = dem_sim_agree(d, status);
    s->caller_data = span;
    status = status ? status
                    : dem_snapshot_write(path, s, &state->decomposition, &state->interaction_table,
                                         &state->particles, &state->contacts, state->pairs.wall_facet);
    dem_snapshot_scene_free(&scene);
    dem_memory_free(record);
    dem_memory_free(span);
    return status;
}

int dem_save(struct dem *d, const char *path)
{
    struct dem_state *const state = &d->state;
    struct dem_snapshot s = {.steps = state->steps, .time = state->time, .domain = &state->domain};

    DEM_TRY(dem_sim_require_sound(d, "dem_save"));
    DEM_TRY(dem_device_return_contacts(state, 1));
    memcpy(s.skin_tuning, &state->pairs.skins, sizeof state->pairs.skins);
    s.flows = state->flows->n;
    s.next_id = state->flows->next_id;
    memcpy(s.flow, state->flows->flow, (size_t)state->flows->n*sizeof *s.flow);
    if (state->window.half_step_ahead)
    {
        s.window = (struct dem_snapshot_window){.ahead = state->window.steps,
                                                .done = state->steps - state->window.steps_before,
                                                .opened = state->window.start,
                                                .dt = state->dt};
    }
    DEM_TRY(write_snapshot(d, path, &s));
    /* A run that loads the file rebuilds its lists first and wraps positions then; the run that
       wrote it does the same, so that both have the same bits. A state without lists stays
       without. */
    dem_request_rebuild(state);
    return DEM_OK;
}

int dem_backup_every(struct dem *d, int64_t steps)
{
    fenv_t caller;

    DEM_TRY(dem_sim_require_sound(d, "dem_backup_every"));
    DEM_REQUIRE(steps >= 0, DEM_ERROR_INPUT, "backups every %lld steps; give a number above 0, or "
                "0 for none", (long long)steps);
    d->state.backup.every = steps;
    feholdexcept(&caller);    /* it checks for numbers that are not finite */
    const int status = dem_step_backup(&d->state);

    fesetenv(&caller);
    return status;
}

int dem_ranks_agree(const struct dem *d)
{
    return !d->ranks_apart;
}

int dem_restore(struct dem *d, double *time)
{
    struct dem_state *const state = &d->state;

    DEM_REQUIRE(state->backup.valid, DEM_ERROR_STATE,
                "there is no backup to restore; dem_backup_every comes before dem_restore");
    DEM_TRY(dem_wall_statistics_restore(state->wall_statistics));
    DEM_TRY(dem_backup_restore(&state->backup, &state->particles, &state->contacts));
    DEM_TRY(state->device ? dem_sim_agree(d, dem_device_restore(state)) : DEM_OK);
    dem_flows_restore(state->flows);
    dem_wall_wear_restore(state);
    dem_energy_balance_restore(state->energy_balance, state->walls.walls);
    dem_walls_rewind(&state->walls);
    dem_wall_bodies_restore(&state->walls);
    dem_unagreed_reset(&state->unagreed);
    d->restored = 1;
    d->failed = 0;
    state->steps = state->backup.steps;
    state->time = *time = state->backup.time;
    state->limits.overlap = 0.0;
    state->lists_state = DEM_NEIGHBORS_NONE;
    state->window = state->backup.window;
    state->dt = state->backup.dt;
    dem_cell_restore(state);
    dem_stages_rewind(d);
    (void)dem_walls_come_and_go(&state->walls, state->time);
    return DEM_OK;
}
