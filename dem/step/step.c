/*
 * step.c -- one step of the particles. Data moves down this page and never up. Only here are all stores in one hand.
 *
 * Leapfrog in kick-drift form. Ranks agree on one thing a step: how fast the fastest particle is, whether anyone asks to stop and
 * whether anyone failed; all other decisions follow from that and from what all ranks know.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/step.h"
#include "step/agree.h"
#include "step/neighbourhood.h"
#include "base/memory.h"
#include "step/motion.h"
#include "step/orientation.h"
#include "step/sum_contacts.h"
#include "step/sweep_bodies.h"
#include "step/sweep_contacts.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- keeping ------------------------------------------------------------------------------------------------- */

/* 1 when a position, a velocity, a spin, a force or a torque is not a number. */
static int is_spoilt(const struct dem_particles *p)
{
    const double *const force = dem_column(p, DEM_COLUMN_FORCE), *const torque = dem_column(p, DEM_COLUMN_TORQUE);
    double sum = 0.0;

    for (size_t i = 0; i < p->n; i++)
    {
        for (size_t k = 0; k < 3; k++)
        {
            sum += 0.0*(p->record[i].x[k] + p->record[i].v[k] + p->record[i].w[k] + force[3*i + k] + torque[3*i + k]);
        }
    }
    return isnan(sum);
}

/* Within a window velocities are half a kick behind: the copy gets it, the run does not feel that it was copied. */
static int keep(struct dem_parts *p, int status, double half_kick)
{
    struct dem_kept *const k = &p->kept;
    double spoilt = is_spoilt(&p->particles);

    DEM_TRY(dem_agree_most(p, status, &spoilt, 1));
    if (spoilt > 0.0)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_kept_take(k, &p->particles, &p->contacts, p->pairs.wall_region));
    dem_flows_keep(&p->flows);
    k->time = p->time;
    k->steps = p->steps;
    if (half_kick > 0.0)
    {
        dem_sweep_bodies(&k->particles, &p->recipe.bodies, &(struct dem_body_sweep){.kick = half_kick, .window = p->window});
        dem_domain_hold(&p->domain, &k->particles);
    }
    return DEM_OK;
}

int dem_step_keep(struct dem_parts *p)
{
    if (p->open)
    {
        p->kept.steps = p->kept.held ? p->kept.steps : p->steps - p->kept.every;
        return DEM_OK;
    }
    return keep(p, DEM_OK, 0.0);
}

/* ---- the step ------------------------------------------------------------------------------------------------ */

/* Who moves by more than its radius in one step may pass through another unseen. Without contact effects anyone may. */
static int not_too_far(const struct dem_parts *p, double fastest, double dt)
{
    const double light = dem_particle_most_speed, most = p->watch.most_speed > 0.0 ? p->watch.most_speed : INFINITY;
    double least = INFINITY;

    for (int c = 0; c < p->recipe.classes; c++)
    {
        const int material = (int)(p->recipe.chain[c].pair.a - p->recipe.material);

        least = p->recipe.chain[c].links > 0 ? fmin(least, p->recipe.least_radius[material]) : least;
    }
    DEM_REQUIRE(p->walls.stride <= least, DEM_ERROR_NUMBER,
                "a wall moves by %.3g m in step %lld at time %g s; the limit is %g m, the radius of the smallest particle, or it may miss a "
                "contact; use a smaller time/step, or a slower motion", p->walls.stride, (long long)p->steps, p->time, least);
    for (size_t i = 0; (fastest*dt > least || fastest > most || fastest > light) && i < p->particles.n; i++)
    {
        const struct dem_particle *const q = &p->particles.record[i];
        const double speed = sqrt(q->v[0]*q->v[0] + q->v[1]*q->v[1] + q->v[2]*q->v[2]);

        DEM_REQUIRE(!isnan(speed), DEM_ERROR_NUMBER, "the velocity of particle %lld is not a number at step %lld; look at the "
                    "forces on it, and at the fluid around it", (long long)q->id, (long long)p->steps);
        DEM_REQUIRE(speed <= most, DEM_ERROR_NUMBER,
                    "particle %lld at (%g %g %g) m has %g m/s in step %lld; the limit time/maxSpeed is %g m/s; look at what pushes it (%s), "
                    "or raise the limit", (long long)q->id, q->x[0], q->x[1], q->x[2], speed, (long long)p->steps, most,
                    p->recipe.step_limit < dt*(1.0 - 1e-9) ? "the step is forced above what its laws stand" : "an impact, a wall, the fluid");
        DEM_REQUIRE(speed <= light, DEM_ERROR_NUMBER, "particle %lld at (%g %g %g) m has %g m/s in step %lld; the limit is %g m/s, the speed of light; "
                    "use a smaller time/step, or look at the forces on it", (long long)q->id, q->x[0], q->x[1], q->x[2], speed, (long long)p->steps,
                    light);
        DEM_REQUIRE(speed*dt <= q->radius, DEM_ERROR_NUMBER,
                    "particle %lld at (%g %g %g) m moves by %.3g m in step %lld, at %g m/s; its radius is %g m, which is the limit, "
                    "or it may miss a contact; use a smaller time/step, or look at the forces on it", (long long)q->id, q->x[0],
                    q->x[1], q->x[2], speed*dt, (long long)p->steps, speed, q->radius);
    }
    return DEM_OK;
}

/* Copies travel while ranks agree; when lists have to be renewed they have travelled in vain. */
static int send_and_agree(struct dem_parts *p, int status, double fastest[2])
{
    if (!p->stale)
    {
        dem_halo_send(&p->halo, &p->particles, DEM_HALO_NEAR);
        dem_phases_end(&p->phases, DEM_PHASE_REFRESH);
    }
    status = dem_agree_most(p, status, fastest, 2);
    if (status || !isfinite(fastest[0]))
    {
        dem_halo_wait(&p->halo);
    }
    DEM_TRY(status);
    DEM_REQUIRE(isfinite(fastest[0]), DEM_ERROR_NUMBER, "a particle's velocity is not a number at step %lld; look at the forces "
                "on it, and at the fluid around it", (long long)p->steps);
    return DEM_OK;
}

static void count_work(struct dem_parts *p)
{
    p->phases.particle_steps += (int64_t)p->particles.n;
    for (int c = 0; c < p->contacts.classes; c++)
    {
        p->phases.row_steps += p->contacts.segment[c].count;
    }
    dem_balance_count(&p->balance, p->particles.n, &p->contacts);
}

/* To where particles are in this step, unless the last one has brought them there. Returns the fastest [m/s]. */
static double drift(struct dem_parts *p, double dt)
{
    struct dem_motion_seen seen = {{0.0}, {0.0}};

    if (p->drifted)
    {
        p->drifted = 0;
        return p->fastest;
    }
    dem_motion_drift(p->particles.record, p->particles.n, dt, p->domain.round, &seen);
    return dem_motion_fastest(&seen);
}

/* The step that ends at p->time. The status of the sweep is kept for the next agreement, so that all ranks stop together. */
static int step(struct dem_parts *p, double dt, double kick, double since, int *status)
{
    dem_phases_step(&p->phases);
    double fastest[2] = {drift(p, dt), p->asked ? (double)*p->asked : 0.0};

    dem_orientation_turn(&p->particles, dt);
    p->steps++;
    dem_walls_move(&p->walls, p->time, dt);
    dem_walls_go(&p->walls, p->steps - p->before, p->ahead);
    if (p->ledger.open)
    {
        dem_ledger_drift(p, dt);
        p->ledger.tells = kick < dt;
    }
    *status = *status ? *status : not_too_far(p, fastest[0], dt);
    dem_phases_end(&p->phases, DEM_PHASE_DRIFT);
    DEM_TRY(send_and_agree(p, *status, fastest));
    p->stopped = (int)fastest[1];
    DEM_TRY(dem_neighbourhood(p, fastest[0]*dt, kick < dt || p->stopped));
    count_work(p);
    const int keeps = p->kept.every > 0 && p->steps >= p->kept.steps + p->kept.every && kick == dt;
    const int watched = dem_durations_due(&p->durations, p->steps);
    const int fused = !keeps && !p->ledger.open, looked = kick < dt || p->stopped || watched || dem_averages_due(&p->averages, p->time);
    const int held = p->domain.flat[0] || p->domain.flat[1] || p->domain.flat[2];
    const struct dem_body_sweep bodies = {.kick = kick, .window = p->window, .ledger = p->ledger.open ? &p->ledger : NULL,
                                          .contacts = fused ? &p->contacts : NULL, .quiet = fused && !looked,
                                          .round = held ? NULL : p->domain.round};
    struct dem_body_pass pass;

    dem_bodies_begin(&pass, &p->particles, &p->recipe.bodies, &bodies);
    *status = dem_sweep_contacts_and(p, dt, (const double[2]){since, p->time}, bodies.contacts ? &pass : NULL);
    dem_phases_end(&p->phases, DEM_PHASE_CONTACTS);
    if (!bodies.contacts)
    {
        dem_sum_contacts(&p->particles, &p->contacts);
    }
    if (p->ledger.open)
    {
        dem_ledger_swept(p, dt);
    }
    dem_wall_books_add(p, kick);
    dem_sum_books(&p->particles, &p->contacts);
    dem_phases_end(&p->phases, DEM_PHASE_SUMS);
    if (keeps)
    {
        dem_phases_rare(&p->phases, DEM_PHASE_SUMS);
        *status = keep(p, *status, 0.5*dt);
        dem_phases_rare_end(&p->phases, DEM_PHASE_KEEP);
    }
    dem_bodies_until(&pass, p->particles.n);
    dem_domain_hold(&p->domain, &p->particles);
    p->drifted = pass.quiet && bodies.round;
    p->fastest = dem_motion_fastest(&pass.seen);
    dem_phases_end(&p->phases, DEM_PHASE_BODIES);
    *status = *status || !watched ? *status : dem_durations_note(&p->durations, p);
    return DEM_OK;
}

static int sample(struct dem_parts *p, int status)
{
    if (!dem_averages_due(&p->averages, p->time))
    {
        return status;
    }
    dem_phases_rare(&p->phases, DEM_PHASE_BODIES);
    status = dem_averages_sample(&p->averages, p, status);
    dem_phases_rare_end(&p->phases, DEM_PHASE_AVERAGES);
    return status;
}

/* The first half kick, or what is left of it. */
static void kick_off(struct dem_parts *p, double kick)
{
    if (kick > 0.0)
    {
        dem_wall_books_add(p, kick);
        dem_sweep_bodies(&p->particles, &p->recipe.bodies, &(struct dem_body_sweep){.kick = kick, .window = p->window,
                         .ledger = p->ledger.open ? &p->ledger : NULL});
    }
    dem_domain_hold(&p->domain, &p->particles);
    dem_phases_end(&p->phases, DEM_PHASE_BODIES);
}

/* The steps of the window that are still to be made, or those until somebody asks to stop. */
static int make_steps(struct dem_parts *p)
{
    int status = DEM_OK;

    p->stopped = p->open = p->drifted = 0;
    for (int64_t k = p->steps - p->before + 1; k <= p->ahead && !p->stopped; k++)
    {
        const double since = p->time;

        p->time = p->opened + (double)k*p->dt;
        DEM_TRY(step(p, p->dt, k < p->ahead ? p->dt : 0.5*p->dt, since, &status));
        status = sample(p, status);
    }
    DEM_TRY(dem_agree(p, status));
    p->open = p->steps - p->before < p->ahead;
    if (!p->open)
    {
        dem_bodies_close(&p->particles, &p->domain, p->window);
    }
    dem_phases_leave(&p->phases);
    return DEM_OK;
}

int dem_step_window(struct dem_parts *p, double dt, int64_t steps)
{
    const double had = p->open ? 0.5*p->dt : 0.0;         /* velocities that an open window left ahead have had theirs */

    p->window = dt*(double)steps;
    p->dt = dt;
    p->opened = p->time;
    p->before = p->steps;
    p->ahead = steps;
    dem_phases_enter(&p->phases, p->particles.n);
    dem_walls_move(&p->walls, p->time, 0.0);
    dem_walls_set_off(&p->walls, p->window);
    dem_bodies_open(&p->particles, &p->recipe.bodies);
    if ((p->recipe.needs & DEM_NEEDS_VISCOSITY || dem_column(&p->particles, DEM_COLUMN_ADDED_MASS)) && !p->stale)
    {
        DEM_TRY(dem_halo_refresh_fluid(&p->halo, &p->particles));
    }
    dem_flows_kick(&p->flows, 0.5*dt - had);
    kick_off(p, 0.5*dt - had);
    return make_steps(p);
}

int dem_step_on(struct dem_parts *p)
{
    dem_phases_enter(&p->phases, p->particles.n);
    return make_steps(p);
}
