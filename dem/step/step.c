/*
 * step.c -- one time step of the particles: leapfrog in kick-drift form. The function dem_step() below
 * is the table of phases; step_window.c makes the steps of a coupling window.
 *
 * 1. Drift positions, rotate orientations, move walls.
 * 2. Send ghost data. All ranks agree on the largest speeds, on a request to stop and on errors
 *    (one all-reduce): in each step, or every few steps where time/maxSpeed bounds how far
 *    particles can have moved.
 * 3. Receive the ghosts, and prune or rebuild the neighbor lists if needed (neighbor_update.c).
 * 4. Contact forces, batch by batch (sweep_contacts.c).
 * 5. Sum the contact forces of each particle (sum_contacts.c), add body and fluid forces, kick
 *    velocities and spins (sweep_bodies.c). In most steps this happens during phase 4, for the
 *    particles whose contact forces are all known.
 * 6. Averages when due. Backup, energy balance and wall statistics need the state within phase 5
 *    and are made there.
 *
 * All other decisions follow from what all ranks know after the all-reduce.
 *
 * With a device, phases 4 and 5 of steps that nothing reads are made there, with the drifts between
 * them (steps_on_device.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/step.h"
#include "core/clock.h"
#include "particles/orientation.h"
#include "particles/scalars.h"
#include "ranks/agree.h"
#include "records/energy_balance.h"
#include "records/grid_averages.h"
#include "records/timers.h"
#include "records/wall_statistics.h"
#include "sources/flows.h"
#include "step/body_window.h"
#include "step/cell_motion.h"
#include "step/clump_batch.h"
#include "step/drift.h"
#include "step/eddies.h"
#include "step/limits.h"
#include "step/neighbor_update.h"
#include "step/step_backup.h"
#include "step/steps_on_device.h"
#include "step/sum_contacts.h"
#include "step/sweep_bodies.h"
#include "step/sweep_contacts.h"
#include "step/wall_bodies.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- phases of the step ---------------------------------------------------------------------- */

/* The drift itself, unless the last step has done so already. Returns the largest speed of this
   rank [m/s]. */
static double drift_particles(struct dem_state *state)
{
    struct dem_drift_speeds speeds = {{0.0}, {0.0}};

    if (state->next_drift.done)
    {
        state->next_drift.done = 0;
        return state->next_drift.max_speed;
    }
    if (state->cell.active)
    {
        return dem_cell_drift(state, state->dt);
    }
    if (state->clumps.n > 0)
    {
        dem_clumps_drift(&state->clumps, &state->particles, &state->domain, state->dt);
    }
    dem_drift_particles(state->particles.record, state->particles.n, state->dt, state->domain.round,
                        &speeds);
    return dem_drift_max_speed(&speeds);
}

/* 1. From here on time and steps of the state refer to the end of the step. Returns the largest
   speed of this rank [m/s]. */
static double drift(struct dem_state *state, int last)
{
    const double max_speed = drift_particles(state);

    dem_orientation_turn(&state->particles, state->dt);
    state->steps++;
    dem_eddies_advance(&state->particles, &state->interaction_table.bodies, state->dt,
                       state->steps);
    if (state->walls.bodies > 0)
    {
        dem_wall_bodies_drift(state);
    }
    dem_walls_move(&state->walls, state->time, state->dt);
    dem_walls_advance(&state->walls, state->steps - state->window.steps_before,
                      state->window.steps);
    if (!state->next_drift.counted)
    {
        dem_wall_statistics_add_work(state, 0.5*state->dt, 1);
    }
    if (state->energy_balance->open && !state->next_drift.counted)
    {
        dem_clumps_store(&state->clumps, &state->particles);
        dem_energy_balance_after_drift(state, state->dt);
    }
    state->energy_balance->sums_elastic = last;
    state->next_drift.counted = 0;
    return max_speed;
}

/* An error of the last step or of this drift, on this rank. */
static int check_drift(struct dem_state *state, double max_speed, int status)
{
    status = dem_unagreed_keep_error(&state->unagreed, status);
    status = status ? status : dem_limits_check_displacements(state, max_speed);
    status = status || !state->cell.active ? status : dem_cell_check(state);
    status = dem_unagreed_keep_error(&state->unagreed, status);
    dem_timers_end_phase(state->timers, DEM_PHASE_DRIFT);
    return status;
}

/* Take the largest displacements [m] of all ranks in the steps since the last agreement. */
static int agree_now(struct dem_state *state, double max[DEM_UNAGREED_STEPS + 1])
{
    struct dem_unagreed *const u = &state->unagreed;
    int status = dem_unagreed_keep_error(u, DEM_OK), invalid = 0;

    memcpy(max, u->moved, (size_t)u->n*sizeof *max);
    max[u->n] = state->stop_request ? (double)*state->stop_request : 0.0;
    status = dem_agree_max(state, status, max, u->n + 1);
    for (int k = 0; k < u->n; k++)
    {
        invalid |= !isfinite(max[k]);
    }
    if (status || invalid)
    {
        dem_halo_wait(&state->halo);
    }
    DEM_TRY(status);
    DEM_REQUIRE(!invalid, DEM_ERROR_NUMBER,
                "a particle's velocity is not a number at step %lld; check the forces "
                "on it, and the fluid around it",
                (long long)state->steps);
    state->window.stopped = (int)max[u->n];
    return DEM_OK;
}

/* 2. Ghost data leaves before the ranks agree, which hides its latency; when lists are rebuilt it
   was not needed. */
static void send_ghosts(struct dem_state *state)
{
    if (state->lists_state == DEM_NEIGHBORS_VALID)
    {
        dem_halo_send(&state->halo, &state->particles, DEM_HALO_NEEDED);
        dem_timers_end_phase(state->timers, DEM_PHASE_REFRESH);
    }
}

/* Agree now, or in a later step when no particle below time/maxSpeed can have used up a skin until
   then; n: number of steps agreed on. */
static int agree(struct dem_state *state, double max_speed, int last,
                 double max[DEM_UNAGREED_STEPS + 1], int *n)
{
    struct dem_unagreed *const u = &state->unagreed;
    const double limit = state->limits.speed_limit > 0.0 ? state->limits.speed_limit : INFINITY;

    u->moved[u->n++] = max_speed*state->dt;
    u->bound += limit*state->dt;
    *n = 0;
    if (last || u->n == DEM_UNAGREED_STEPS || state->device ||
        dem_neighbor_agreement_due(state, u->bound))
    {
        DEM_TRY(agree_now(state, max));
        *n = u->n;
        dem_unagreed_reset(u);
    }
    return DEM_OK;
}

static void count_work(struct dem_state *state)
{
    state->timers->particle_steps += (int64_t)state->particles.n;
    for (int c = 0; c < state->contacts.rows.classes; c++)
    {
        state->timers->row_steps += state->contacts.rows.segment[c].count;
    }
    dem_load_balance_count(&state->load_balance, state->particles.n, &state->contacts);
}

struct due    /* what is due in this step, and what follows from it for the sweeps */
{
    int backup;
    int fused;              /* particles are summed and kicked during the sweep of contacts */
    int observed;           /* forces or positions are read after this step */
};

static struct due what_is_due(const struct dem_state *state, int last)
{
    struct due due = {0};

    due.backup = state->backup.every > 0 &&
                 state->steps >= state->backup.steps + state->backup.every && !last;
    due.fused = !due.backup && !state->energy_balance->open;
    due.observed = last || state->window.stopped || dem_grid_averages_due(state->averages, state->time) ||
    (state->cell.active && dem_cell_control_due(state));
    return due;
}

struct dem_body_sweep dem_step_sweep(const struct dem_state *state, double kick, double h)
{
    return (struct dem_body_sweep){
        .kick = kick,
        .window = state->window.length,
        .applied = dem_applied_forces_exist(&state->applied_forces) ? &state->applied_forces : NULL,
        .domain = &state->domain,
        .time = state->time,
        .energy_balance = state->energy_balance->open ? state->energy_balance : NULL,
        .clumps = state->clumps.n > 0 ? &state->clumps : NULL,
        .clump_flow = state->clumps.flow,
        .scalars = {.table = state->interaction_table.listed ? &state->interaction_table : NULL,
                    .contacts = &state->contacts,
                    .clump_heat = state->clumps.heat,
                    .h = h,
                    .window = state->window.length}};
}

static struct dem_body_sweep sweep_options(const struct dem_state *state, const struct due *due,
                                           double kick)
{
    const int flat = state->domain.flat[0] || state->domain.flat[1] || state->domain.flat[2];
    struct dem_body_sweep sweep = dem_step_sweep(state, kick, state->dt);

    sweep.contacts = &state->contacts;
    sweep.sums_first = !due->fused;
    sweep.unobserved = due->fused && !due->observed;
    sweep.round = flat || state->cell.active || sweep.clumps ? NULL : state->domain.round;
    sweep.scalars.heat = state->energy_balance->open
                             ? &state->energy_balance->sum[DEM_ENERGY_BALANCE_HEAT_BODIES]
                             : NULL;
    return sweep;
}

/* A value of a scalar out of its range ends the run. */
static int check_scalars(const struct dem_state *state, const struct dem_body_pass *pass,
                         int status)
{
    char when[64];

    if (status || pass->bad_scalars == 0)
    {
        return status;
    }
    snprintf(when, sizeof when, " in step %lld", (long long)state->steps);
    return dem_scalars_check(&state->particles, &state->interaction_table, when);
}

/* 5. Most particles are summed already, and in a fused step kicked; the pass knows which. */
static int sum_and_kick(struct dem_state *state, const struct due *due, struct dem_body_pass *pass,
                        int status)
{
    dem_bodies_finish_sums(pass);
    if (state->energy_balance->open)
    {
        dem_energy_balance_after_sweep(state, state->dt);
    }
    dem_wall_statistics_add_work(state, 0.5*state->dt, 0);
    dem_wall_statistics_add_kick(state, pass->sweep->kick);
    dem_sum_bond_energies(&state->particles, &state->contacts);
    if (state->walls.bodies > 0)
    {
        const int moved = dem_wall_bodies_sum(state);

        status = status ? status : moved;
    }
    dem_timers_end_phase(state->timers, DEM_PHASE_SUMS);
    if (due->backup)
    {
        const struct dem_body_sweep half = dem_step_sweep(state, 0.5*state->dt, state->dt);

        dem_timers_begin_rare_phase(state->timers, DEM_PHASE_SUMS);
        status = dem_step_backup_ahead(state, dem_unagreed_keep_error(&state->unagreed, status),
                                       &half);
        dem_timers_end_rare_phase(state->timers, DEM_PHASE_BACKUP);
    }
    if (state->walls.bodies > 0)
    {
        dem_wall_bodies_kick(state, pass->sweep->kick);
    }
    dem_bodies_work_until(pass, state->particles.n);
    if (state->clumps.n > 0)
    {
        pass->bad_scalars += dem_kick_clumps(state, &state->particles, pass->sweep);
    }
    dem_domain_constrain(&state->domain, &state->particles);
    state->next_drift.done = pass->unobserved && pass->sweep->round;
    state->next_drift.max_speed = dem_drift_max_speed(&pass->speeds);
    dem_timers_end_phase(state->timers, DEM_PHASE_BODIES);
    return check_scalars(state, pass, status);
}

/* 6. */
static int sample_averages(struct dem_state *state, int status)
{
    if (dem_grid_averages_due(state->averages, state->time))
    {
        dem_timers_begin_rare_phase(state->timers, DEM_PHASE_BODIES);
        dem_clumps_store(&state->clumps, &state->particles);
        status = dem_grid_averages_sample(state->averages, state, status);
        dem_timers_end_rare_phase(state->timers, DEM_PHASE_AVERAGES);
    }
    return status;
}

int dem_step_ask_for_forces(struct dem_state *state)
{
    return state->applied_forces.program.add
               ? dem_applied_forces_ask(&state->applied_forces, &state->particles, state->domain.length, state->time)
               : DEM_OK;
}

/* ---- the step -------------------------------------------------------------------------------- */

/* The first half of a step, up to the positions and lists of state->time. An error of this rank
   after the agreement, or in a step without one, is kept for the next agreement, so that all ranks
   stop together. */
static int begin_step(struct dem_state *state, int last, int *status)
{
    double moved[DEM_UNAGREED_STEPS + 1];
    int agreed;

    /* 1. drift */
    dem_timers_begin_step(state->timers);
    const double max_speed = drift(state, last);

    *status = check_drift(state, max_speed, *status);

    /* 2. send ghost data, agree */
    send_ghosts(state);
    DEM_TRY(agree(state, max_speed, last, moved, &agreed));

    /* 3. refresh ghosts, prune or rebuild */
    DEM_TRY(dem_neighbor_update(state, moved, agreed, last || state->window.stopped));
    count_work(state);
    return DEM_OK;
}

/* The second half: the forces of the step from `since` [s] to state->time, and the kick; the last one
   of a window is half a kick. */
static void finish_step(struct dem_state *state, double since, int last, int *status)
{
    const double kick = last ? 0.5*state->dt : state->dt;
    struct dem_body_pass pass;

    const struct due due = what_is_due(state, last);

    state->energy_balance->sums_elastic |= due.backup;
    const struct dem_body_sweep sweep = sweep_options(state, &due, kick);

    const int asked = dem_step_ask_for_forces(state);

    /* 4. contacts */
    dem_bodies_begin_pass(&pass, &state->particles, &state->interaction_table.bodies, &sweep);
    const int swept = dem_sweep_contacts_and_bodies(
        state, state->dt, (const double[2]){since, state->time}, &pass);

    *status = swept ? swept : asked;
    dem_timers_end_phase(state->timers, DEM_PHASE_CONTACTS);

    /* 5. sums, body and fluid forces, kick */
    *status = sum_and_kick(state, &due, &pass, *status);

    /* 6. averages; the rates of a cell */
    *status = sample_averages(state, *status);
    if (state->cell.active && dem_cell_control_due(state))
    {
        const int measured = dem_cell_control(state);

        *status = *status ? *status : measured;
    }
}

int dem_step(struct dem_state *state, double since, int64_t *k, int *status)
{
    const int last = *k == state->window.steps;
    int64_t made = 0;

    DEM_TRY(begin_step(state, last, status));
    if (state->device && !*status)
    {
        DEM_TRY(dem_steps_on_device(state, *k, &made));
    }
    if (made == 0)
    {
        finish_step(state, since, last, status);
    }
    *k += made > 0 ? made - 1 : 0;
    return DEM_OK;
}
