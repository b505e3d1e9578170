/*
 * step.c -- one time step of the particles: leapfrog in kick-drift form, and the coupling window of
 * steps around it. The function step() below is the table of phases:
 *
 * 1. Drift positions, rotate orientations, move walls.
 * 2. Send ghost data. All ranks agree on the largest speeds, on a request to stop and on errors (one
 *    all-reduce): in each step, or every few steps where time/maxSpeed bounds how far particles can
 *    have moved.
 * 3. Update the neighbor lists: refresh ghosts, prune, or rebuild (neighbor_update.c).
 * 4. Contact forces, batch by batch (sweep_contacts.c).
 * 5. Sum the contact forces of each particle (sum_contacts.c), add body and fluid forces, kick
 *    velocities and spins (sweep_bodies.c). In most steps this happens during phase 4, for the
 *    particles whose contact forces are all known.
 * 6. Averages when due. Backup, energy balance and wall statistics need the state within phase 5 and
 *    are made there.
 *
 * All other decisions follow from what all ranks know after the all-reduce.
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
#include "step/drift.h"
#include "step/eddies.h"
#include "step/limits.h"
#include "step/neighbor_update.h"
#include "step/step_backup.h"
#include "step/sum_contacts.h"
#include "step/sweep_bodies.h"
#include "step/sweep_contacts.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The integration of particle scalars over h [s]; 0: none, they are only read. */
static struct dem_scalar_step scalar_step(const struct dem_state *p, double h)
{
    return (struct dem_scalar_step){.table =
                                        p->interaction_table.listed ? &p->interaction_table : NULL,
                                    .contacts = &p->contacts,
                                    .h = h,
                                    .window = p->window.length};
}

/* ---- phases of the step ---------------------------------------------------------------------- */

/* The drift itself, unless the last step has done so already. Returns the largest speed of this
   rank [m/s]. */
static double drift_particles(struct dem_state *p)
{
    struct dem_drift_speeds speeds = {{0.0}, {0.0}};

    if (p->next_drift.done)
    {
        p->next_drift.done = 0;
        return p->next_drift.max_speed;
    }
    dem_drift_particles(p->particles.record, p->particles.n, p->dt, p->domain.round, &speeds);
    return dem_drift_max_speed(&speeds);
}

/* 1. From here on p->time and p->steps refer to the end of the step. Returns the largest speed
   of this rank [m/s]. */
static double drift(struct dem_state *p, int last)
{
    const double max_speed = drift_particles(p);

    dem_orientation_turn(&p->particles, p->dt);
    p->steps++;
    dem_eddies_advance(&p->particles, &p->interaction_table.bodies, p->dt, p->steps);
    dem_walls_move(&p->walls, p->time, p->dt);
    dem_walls_advance(&p->walls, p->steps - p->window.steps_before, p->window.steps);
    if (p->energy_balance->open)
    {
        dem_energy_balance_after_drift(p, p->dt);
        p->energy_balance->sums_elastic = last;
    }
    return max_speed;
}

/* An error of the last step or of this drift, on this rank. */
static int check_drift(struct dem_state *p, double max_speed, int status)
{
    status = dem_unagreed_keep_error(&p->unagreed, status);
    status = status ? status : dem_limits_check_displacements(p, max_speed);
    status = dem_unagreed_keep_error(&p->unagreed, status);
    dem_timers_end_phase(p->timers, DEM_PHASE_DRIFT);
    return status;
}

/* Take the largest displacements [m] of all ranks in the steps since the last agreement. */
static int agree_now(struct dem_state *p, double max[DEM_UNAGREED_STEPS + 1])
{
    struct dem_unagreed *const u = &p->unagreed;
    int status = dem_unagreed_keep_error(u, DEM_OK), invalid = 0;

    memcpy(max, u->moved, (size_t)u->n*sizeof *max);
    max[u->n] = p->stop_request ? (double)*p->stop_request : 0.0;
    status = dem_agree_max(p, status, max, u->n + 1);
    for (int k = 0; k < u->n; k++)
    {
        invalid |= !isfinite(max[k]);
    }
    if (status || invalid)
    {
        dem_halo_wait(&p->halo);
    }
    DEM_TRY(status);
    DEM_REQUIRE(!invalid, DEM_ERROR_NUMBER,
                "a particle's velocity is not a number at step %lld; check the forces "
                "on it, and the fluid around it",
                (long long)p->steps);
    p->window.stopped = (int)max[u->n];
    return DEM_OK;
}

/* 2. Ghost data leaves before the ranks agree, which hides its latency; when lists are rebuilt it was
   not needed. */
static void send_ghosts(struct dem_state *p)
{
    if (!p->stale)
    {
        dem_halo_send(&p->halo, &p->particles, DEM_HALO_CANDIDATES);
        dem_timers_end_phase(p->timers, DEM_PHASE_REFRESH);
    }
}

/* Agree now, or in a later step when no particle below time/maxSpeed can have used up a skin until
   then; n: number of steps agreed on. */
static int agree(struct dem_state *p, double max_speed, int last,
                 double max[DEM_UNAGREED_STEPS + 1], int *n)
{
    struct dem_unagreed *const u = &p->unagreed;
    const double limit = p->limits.max_speed > 0.0 ? p->limits.max_speed : INFINITY;

    u->moved[u->n++] = max_speed*p->dt;
    u->bound += limit*p->dt;
    *n = 0;
    if (last || u->n == DEM_UNAGREED_STEPS || dem_neighbor_agreement_due(p, u->bound))
    {
        DEM_TRY(agree_now(p, max));
        *n = u->n;
        dem_unagreed_reset(u);
    }
    return DEM_OK;
}

static void count_work(struct dem_state *p)
{
    p->timers->particle_steps += (int64_t)p->particles.n;
    for (int c = 0; c < p->contacts.rows.classes; c++)
    {
        p->timers->row_steps += p->contacts.rows.segment[c].count;
    }
    dem_load_balance_count(&p->load_balance, p->particles.n, &p->contacts);
}

struct due    /* what is due in this step, and what follows from it for the sweeps */
{
    int backup;
    int fused;              /* particles are summed and kicked during the sweep of contacts */
    int observed;           /* forces or positions are read after this step */
};

static struct due what_is_due(const struct dem_state *p, int last)
{
    struct due due = {0};

    due.backup = p->backup.every > 0 && p->steps >= p->backup.steps + p->backup.every && !last;
    due.fused = !due.backup && !p->energy_balance->open;
    due.observed = last || p->window.stopped || dem_grid_averages_due(p->averages, p->time);
    return due;
}

static struct dem_body_sweep sweep_options(const struct dem_state *p, const struct due *due,
                                           double kick)
{
    const int flat = p->domain.flat[0] || p->domain.flat[1] || p->domain.flat[2];
    struct dem_scalar_step scalars = scalar_step(p, p->dt);

    scalars.heat = p->energy_balance->open
                       ? &p->energy_balance->sum[DEM_ENERGY_BALANCE_HEAT_BODIES]
                       : NULL;
    return (struct dem_body_sweep){
        .kick = kick,
        .window = p->window.length,
        .contacts = &p->contacts,
        .sums_first = !due->fused,
        .unobserved = due->fused && !due->observed,
        .round = flat ? NULL : p->domain.round,
        .applied = p->applied_forces.n > 0 ? &p->applied_forces : NULL,
        .time = p->time,
        .energy_balance = p->energy_balance->open ? p->energy_balance : NULL,
        .scalars = scalars};
}

/* A value of a scalar out of its range ends the run. */
static int check_scalars(const struct dem_state *p, const struct dem_body_pass *pass, int status)
{
    char when[64];

    if (status || pass->bad_scalars == 0)
    {
        return status;
    }
    snprintf(when, sizeof when, " in step %lld", (long long)p->steps);
    return dem_scalars_check(&p->particles, &p->interaction_table, when);
}

/* 5. Most particles are summed already, and in a fused step kicked; the pass knows which. */
static int sum_and_kick(struct dem_state *p, const struct due *due, struct dem_body_pass *pass,
                        int status)
{
    dem_bodies_finish_sums(pass);
    if (p->energy_balance->open)
    {
        dem_energy_balance_after_sweep(p, p->dt);
    }
    dem_wall_statistics_add_kick(p, pass->sweep->kick);
    dem_sum_bond_energies(&p->particles, &p->contacts);
    dem_timers_end_phase(p->timers, DEM_PHASE_SUMS);
    if (due->backup)
    {
        const struct dem_body_sweep half = {
            .kick = 0.5*p->dt, .window = p->window.length, .scalars = scalar_step(p, p->dt)};

        dem_timers_begin_rare_phase(p->timers, DEM_PHASE_SUMS);
        status = dem_step_backup_ahead(p, dem_unagreed_keep_error(&p->unagreed, status), &half);
        dem_timers_end_rare_phase(p->timers, DEM_PHASE_BACKUP);
    }
    dem_bodies_work_until(pass, p->particles.n);
    dem_domain_constrain(&p->domain, &p->particles);
    p->next_drift.done = pass->unobserved && pass->sweep->round;
    p->next_drift.max_speed = dem_drift_max_speed(&pass->speeds);
    dem_timers_end_phase(p->timers, DEM_PHASE_BODIES);
    return check_scalars(p, pass, status);
}

/* 6. */
static int sample_averages(struct dem_state *p, int status)
{
    if (dem_grid_averages_due(p->averages, p->time))
    {
        dem_timers_begin_rare_phase(p->timers, DEM_PHASE_BODIES);
        status = dem_grid_averages_sample(p->averages, p, status);
        dem_timers_end_rare_phase(p->timers, DEM_PHASE_AVERAGES);
    }
    return status;
}

/* ---- the step -------------------------------------------------------------------------------- */

/* The step from `since` [s] to p->time; the last one of a window ends with half a kick. An error of
   this rank after the agreement, or in a step without one, is kept for the next one, so that all
   ranks stop together. */
static int step(struct dem_state *p, double since, int last, int *status)
{
    const double kick = last ? 0.5*p->dt : p->dt;
    struct dem_body_pass pass;
    double moved[DEM_UNAGREED_STEPS + 1];
    int agreed;

    /* 1. drift */
    dem_timers_begin_step(p->timers);
    const double max_speed = drift(p, last);

    *status = check_drift(p, max_speed, *status);

    /* 2. send ghost data, agree */
    send_ghosts(p);
    DEM_TRY(agree(p, max_speed, last, moved, &agreed));

    /* 3. refresh ghosts, prune or rebuild */
    DEM_TRY(dem_neighbor_update(p, moved, agreed, last || p->window.stopped));
    count_work(p);

    const struct due due = what_is_due(p, last);
    const struct dem_body_sweep sweep = sweep_options(p, &due, kick);

    /* 4. contacts */
    dem_bodies_begin_pass(&pass, &p->particles, &p->interaction_table.bodies, &sweep);
    *status = dem_sweep_contacts_and_bodies(p, p->dt, (const double[2]){since, p->time}, &pass);
    dem_timers_end_phase(p->timers, DEM_PHASE_CONTACTS);

    /* 5. sums, body and fluid forces, kick */
    *status = sum_and_kick(p, &due, &pass, *status);

    /* 6. averages */
    *status = sample_averages(p, *status);
    return DEM_OK;
}

/* ---- the window ------------------------------------------------------------------------------ */

/* The first half kick of a window, or the rest of it. */
static void first_kick(struct dem_state *p, double kick)
{
    if (kick > 0.0)
    {
        dem_wall_statistics_add_kick(p, kick);
        dem_sweep_bodies(&p->particles, &p->interaction_table.bodies,
                         &(struct dem_body_sweep){
                             .kick = kick,
                             .window = p->window.length,
                             .applied = p->applied_forces.n > 0 ? &p->applied_forces : NULL,
                             .time = p->time,
                             .energy_balance = p->energy_balance->open
                                                   ? p->energy_balance
                                                   : NULL,
                             .scalars = scalar_step(p, 0.0)});
    }
    dem_domain_constrain(&p->domain, &p->particles);
    dem_timers_end_phase(p->timers, DEM_PHASE_BODIES);
}

/* The clock is read once in 16 steps. */
static void tell_progress(struct dem_state *p)
{
    struct dem_progress *const q = &p->progress;

    if (q->report && p->steps%16 == 0)
    {
        const double now = dem_clock_wall();

        if (now - q->last >= q->seconds)
        {
            q->last = now;
            q->report(q->self, p->time, p->steps);
        }
    }
}

/* The remaining steps of the window, or those until a stop is requested. */
static int make_steps(struct dem_state *p)
{
    int status = DEM_OK;

    p->window.stopped = p->window.half_step_ahead = p->next_drift.done = 0;
    for (int64_t k = p->steps - p->window.steps_before + 1;
         k <= p->window.steps && !p->window.stopped;
         k++)
    {
        const double since = p->time;
        const int last = k == p->window.steps;

        p->time = p->window.start + (double)k*p->dt;
        DEM_TRY(step(p, since, last, &status));
        tell_progress(p);
    }
    DEM_TRY(dem_agree(p, status));
    p->window.half_step_ahead = p->steps - p->window.steps_before < p->window.steps;
    if (!p->window.half_step_ahead)
    {
        dem_bodies_end_window(&p->particles, &p->domain, p->window.length);
        dem_scalars_end_window(&p->particles, &p->interaction_table);
    }
    dem_timers_end_advance(p->timers);
    return DEM_OK;
}

int dem_step_window(struct dem_state *p, double dt, int64_t steps)
{
    /* s  an open window has left velocities ahead by this */
    const double done = p->window.half_step_ahead ? 0.5*p->dt : 0.0;

    p->window.length = dt*(double)steps;
    p->dt = dt;
    p->window.start = p->time;
    p->window.steps_before = p->steps;
    p->window.steps = steps;
    dem_timers_begin_advance(p->timers, p->particles.n, steps);
    dem_walls_move(&p->walls, p->time, 0.0);
    dem_walls_begin_advance(&p->walls, p->window.length);
    dem_bodies_begin_window(&p->particles, &p->interaction_table.bodies);
    dem_scalars_begin_window(&p->particles, &p->interaction_table);
    if ((p->particles.ghost_window.n > 0 || dem_column(&p->particles, DEM_COLUMN_ADDED_MASS)) &&
        !p->stale)
    {
        DEM_TRY(dem_halo_refresh_window(&p->halo, &p->particles));
    }
    dem_flows_complete_departures(p->flows, 0.5*dt - done);
    first_kick(p, 0.5*dt - done);
    return make_steps(p);
}

int dem_step_continue(struct dem_state *p)
{
    dem_timers_begin_advance(p->timers, p->particles.n,
                             p->window.steps - (p->steps - p->window.steps_before));
    return make_steps(p);
}
