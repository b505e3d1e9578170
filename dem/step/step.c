/*
 * step.c -- one step of the particles. Data moves down this page and never up. Only here are all stores in one hand.
 *
 * Leapfrog in kick-drift form. Ranks agree on one thing a step: how fast the fastest particle is and whether anyone
 * failed; all other decisions follow from that and from what all ranks know.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/step.h"
#include "base/memory.h"
#include "step/loss_cause.h"
#include "step/motion.h"
#include "step/orientation.h"
#include "step/sum_contacts.h"
#include "step/sweep_bodies.h"
#include "step/sweep_contacts.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum
{
    FULL_TEXT = DEM_ERROR_TEXT_SIZE
};

/* Who has left the domain is removed at steps that are multiples of this, not when lists happen to be renewed: their cost must not
   change results. */
enum
{
    STEPS_OF_LEAVE = 32
};

/* ---- agreeing ------------------------------------------------------------------------------------------------ */

/* The failing rank of lowest number tells all the others its sentence; all return its status. */
static int fail_together(const struct dem_parts *p, int status)
{
    char text[FULL_TEXT];
    int speaker = status ? p->pieces.rank : p->pieces.ranks;

    MPI_Allreduce(MPI_IN_PLACE, &speaker, 1, MPI_INT, MPI_MIN, p->pieces.comm);
    snprintf(text, sizeof text, "%s", dem_error_text());
    MPI_Bcast(text, FULL_TEXT, MPI_CHAR, speaker, p->pieces.comm);
    MPI_Bcast(&status, 1, MPI_INT, speaker, p->pieces.comm);
    return dem_error(status, "%s", text);
}

/* The largest of two numbers over all ranks; fails on all ranks if one has failed. */
static int agree(struct dem_parts *p, int status, double value[2])
{
    double all[3] = {value[0], value[1], status ? 1.0 : 0.0};

    if (p->pieces.ranks == 1)
    {
        return status;
    }
    p->phases.agreements++;
    MPI_Allreduce(MPI_IN_PLACE, all, 3, MPI_DOUBLE, MPI_MAX, p->pieces.comm);
    value[0] = all[0];
    value[1] = all[1];
    return all[2] > 0.0 ? fail_together(p, status) : DEM_OK;
}

/* ---- the neighbourhood --------------------------------------------------------------------------------------- */

/* Who is outside is noted, to be removed, or an error. */
static int send_off(struct dem_parts *p, size_t i)
{
    const struct dem_particle *const q = &p->particles.record[i];
    char cause[DEM_CAUSE_SIZE];

    DEM_REQUIRE(isfinite(q->x[0] + q->x[1] + q->x[2]), DEM_ERROR_NUMBER,
                "the position of particle %lld is not a number at step %lld; look at its input and at the fluid around it",
                (long long)q->id, (long long)p->steps);
    dem_loss_cause_outside(p, i, cause);
    if (p->ledger.open)
    {
        dem_ledger_leaves(p, q);
    }
    DEM_REQUIRE(p->domain.remove, DEM_ERROR_LOST,
                "particle %lld left the domain at (%g %g %g) m at time %g s: %s; enlarge the domain, close it with a wall, or set "
                "domain/leaving remove", (long long)q->id, q->x[0], q->x[1], q->x[2], p->time, cause);
    return dem_losses_note(&p->losses, q, p->time, 1, cause);
}

static int leave_is_over(const struct dem_parts *p)
{
    return !p->domain.remove || p->steps%STEPS_OF_LEAVE == 0;
}

/* 1 on all ranks when somebody is to be removed now. */
static int somebody_goes(struct dem_parts *p, int *goes)
{
    double outside[2] = {0.0, 0.0};

    *goes = 0;
    if (!p->domain.remove || !leave_is_over(p))
    {
        return DEM_OK;
    }
    for (size_t i = 0; i < p->particles.n; i++)
    {
        outside[0] = dem_domain_holds(&p->domain, p->particles.record[i].x) ? outside[0] : 1.0;
    }
    DEM_TRY(agree(p, DEM_OK, outside));
    *goes = outside[0] > 0.0;
    return DEM_OK;
}

/* Wrap along periodic axes; who is outside then goes, with its weight if there are weights. */
static int bring_home(struct dem_parts *p, int weighed)
{
    struct dem_particle *const record = p->particles.record;
    const size_t n = p->particles.n;
    int status = DEM_OK;
    uint32_t *order;
    size_t kept = 0;

    DEM_TRY(DEM_NEW(order, n + 1));
    for (size_t i = 0; i < n && !status; i++)
    {
        dem_domain_wrap(&p->domain, &record[i]);
        if (dem_domain_holds(&p->domain, record[i].x) || (!leave_is_over(p) && isfinite(record[i].x[0] + record[i].x[1] + record[i].x[2])))
        {
            order[kept++] = (uint32_t)i;
        }
        else
        {
            status = send_off(p, i);
        }
    }
    if (!status && kept < n)
    {
        dem_particles_reorder(&p->particles, order, kept);
        if (weighed)
        {
            dem_balance_keep(&p->balance, order, kept);
        }
    }
    dem_memory_free(order);
    return status;
}

static int hand_over(struct dem_parts *p, int cut, int weighed)
{
    if (cut)
    {
        DEM_TRY(dem_pieces_balance(&p->pieces, &p->particles, weighed ? p->balance.weight : NULL));
    }
    return dem_halo_migrate(&p->halo, &p->particles, &p->contacts);
}

static int prune(struct dem_parts *p)
{
    p->prunes++;
    dem_walls_remark(&p->walls, DEM_LIST_INNER);
    DEM_TRY(dem_pairs_prune(&p->pairs, &p->particles, &p->walls, &p->contacts));
    dem_wall_touches_rows(&p->touches, &p->pairs.search, &p->contacts);
    return DEM_OK;
}

int dem_step_renew(struct dem_parts *p)
{
    const int cut = dem_balance_pays(&p->balance, &p->pieces), weighed = cut && p->stale < 2;
    double none[2] = {0.0, 0.0};
    int status = weighed ? dem_balance_weigh(&p->balance, &p->particles, &p->contacts) : DEM_OK;

    status = status ? status : dem_contacts_lift(&p->contacts, &p->particles, p->pairs.wall_region);
    status = status ? status : bring_home(p, weighed);
    DEM_TRY(agree(p, status, none));
    DEM_TRY(hand_over(p, cut, weighed));
    DEM_TRY(dem_pairs_order(&p->pairs, &p->particles));
    DEM_TRY(dem_halo_renew(&p->halo, &p->particles, &p->domain, p->pairs.most_radius, p->pairs.outer));
    status = dem_pairs_find(&p->pairs, &p->domain, &p->particles, &p->walls, &p->recipe, &p->contacts);
    DEM_TRY(agree(p, status, none));
    DEM_TRY(dem_wall_touches_fit(&p->touches, &p->pairs.search));
    dem_walls_remark(&p->walls, DEM_LIST_OUTER);
    DEM_TRY(prune(p));
    DEM_TRY(dem_contacts_settle(&p->contacts, &p->particles, p->pairs.wall_region));
    p->stale = 0;
    p->rebuilds++;
    return DEM_OK;
}

/* After a drift: rebuild, prune, or neither, from the bounds on how far anyone has moved. Particles and walls may each use
   up half a skin. */
static int neighbourhood(struct dem_parts *p, double fastest, double dt)
{
    struct dem_pairs *const s = &p->pairs;
    double moved[2];
    int goes;

    DEM_TRY(somebody_goes(p, &goes));
    s->moved_outer += fastest*dt;
    s->moved_inner += fastest*dt;
    if (!p->stale && (s->moved_outer > s->half_outer || s->moved_inner > s->half_inner))
    {
        dem_pairs_moved(s, &p->particles, &moved[0], &moved[1]);
        DEM_TRY(agree(p, DEM_OK, moved));
        s->moved_outer = moved[0];
        s->moved_inner = moved[1];
    }
    dem_phases_end(&p->phases, DEM_PHASE_AGREE);
    if (p->stale || goes || s->moved_outer > s->half_outer || dem_walls_moved(&p->walls, DEM_LIST_OUTER) > s->half_outer)
    {
        dem_phases_rare(&p->phases, DEM_PHASE_AGREE);
        dem_halo_wait(&p->halo);
        DEM_TRY(dem_step_renew(p));
        dem_phases_rare_end(&p->phases, DEM_PHASE_RENEW);
        return DEM_OK;
    }
    dem_halo_receive(&p->halo, &p->particles);
    dem_phases_end(&p->phases, DEM_PHASE_REFRESH);
    if (s->moved_inner > s->half_inner || dem_walls_moved(&p->walls, DEM_LIST_INNER) > s->half_inner)
    {
        DEM_TRY(prune(p));
        dem_phases_end(&p->phases, DEM_PHASE_PRUNE);
    }
    return DEM_OK;
}

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
    double spoilt[2] = {is_spoilt(&p->particles), 0.0};

    DEM_TRY(agree(p, status, spoilt));
    if (spoilt[0] > 0.0)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_kept_take(k, &p->particles, &p->contacts, p->pairs.wall_region));
    k->time = p->time;
    k->steps = p->steps;
    if (half_kick > 0.0)
    {
        dem_sweep_bodies(&k->particles, &p->recipe.bodies, half_kick, p->window, NULL);
    }
    return DEM_OK;
}

int dem_step_keep(struct dem_parts *p)
{
    return keep(p, DEM_OK, 0.0);
}

/* ---- the step ------------------------------------------------------------------------------------------------ */

/* Who moves by more than its radius in one step may pass through another unseen. Without contact effects anyone may. */
static int not_too_far(const struct dem_parts *p, double fastest, double dt)
{
    double least = INFINITY;

    for (int c = 0; c < p->recipe.classes; c++)
    {
        const int material = (int)(p->recipe.chain[c].pair.a - p->recipe.material);

        least = p->recipe.chain[c].links > 0 ? fmin(least, p->recipe.least_radius[material]) : least;
    }
    DEM_REQUIRE(p->walls.stride <= least, DEM_ERROR_NUMBER,
                "a wall moves by %.3g m in step %lld at time %g s; the limit is %g m, the radius of the smallest particle, or it may miss a "
                "contact; use a smaller time/step, or a slower motion", p->walls.stride, (long long)p->steps, p->time, least);
    for (size_t i = 0; fastest*dt > least && i < p->particles.n; i++)
    {
        const struct dem_particle *const q = &p->particles.record[i];
        const double speed = sqrt(q->v[0]*q->v[0] + q->v[1]*q->v[1] + q->v[2]*q->v[2]);

        DEM_REQUIRE(!isnan(speed), DEM_ERROR_NUMBER, "the velocity of particle %lld is not a number at step %lld; look at the "
                    "forces on it, and at the fluid around it", (long long)q->id, (long long)p->steps);
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
        dem_halo_send(&p->halo, &p->particles);
        dem_phases_end(&p->phases, DEM_PHASE_REFRESH);
    }
    status = agree(p, status, fastest);
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

/* The step that ends at p->time. The status of the sweep is kept for the next agreement, so that all ranks stop together. */
static int step(struct dem_parts *p, double dt, double kick, double since, int *status)
{
    dem_phases_step(&p->phases);
    double fastest[2] = {dem_motion_drift(&p->particles, dt, p->domain.round), 0.0};

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
    DEM_TRY(neighbourhood(p, fastest[0], dt));
    count_work(p);
    *status = dem_sweep_contacts(p, dt, (const double[2]){since, p->time});
    dem_phases_end(&p->phases, DEM_PHASE_CONTACTS);
    dem_sum_contacts(&p->particles, &p->contacts);
    if (p->ledger.open)
    {
        dem_ledger_swept(p, dt);
    }
    dem_wall_books_add(p, kick);
    dem_sum_books(&p->particles, &p->contacts);
    dem_phases_end(&p->phases, DEM_PHASE_SUMS);
    if (p->kept.every > 0 && p->steps >= p->kept.steps + p->kept.every && kick == dt)
    {
        dem_phases_rare(&p->phases, DEM_PHASE_SUMS);
        *status = keep(p, *status, 0.5*dt);
        dem_phases_rare_end(&p->phases, DEM_PHASE_KEEP);
    }
    dem_sweep_bodies(&p->particles, &p->recipe.bodies, kick, p->window, p->ledger.open ? &p->ledger : NULL);
    dem_phases_end(&p->phases, DEM_PHASE_BODIES);
    return DEM_OK;
}

static int sample(struct dem_parts *p)
{
    if (!dem_averages_due(&p->averages, p->time))
    {
        return DEM_OK;
    }
    dem_phases_rare(&p->phases, DEM_PHASE_BODIES);
    DEM_TRY(dem_averages_sample(&p->averages, p));
    dem_phases_rare_end(&p->phases, DEM_PHASE_AVERAGES);
    return DEM_OK;
}

int dem_step_window(struct dem_parts *p, double dt, int64_t steps)
{
    const double start = p->time, window = dt*(double)steps;
    double none[2] = {0.0, 0.0};
    int status = DEM_OK;

    p->window = window;
    p->dt = dt;
    p->before = p->steps;
    p->ahead = steps;
    dem_phases_enter(&p->phases, p->particles.n);
    dem_walls_move(&p->walls, start, 0.0);
    dem_walls_set_off(&p->walls, window);
    dem_bodies_open(&p->particles, &p->recipe.bodies);
    if (p->recipe.needs & DEM_NEEDS_VISCOSITY && !p->stale)
    {
        DEM_TRY(dem_halo_refresh_viscosity(&p->halo, &p->particles));
    }
    dem_wall_books_add(p, 0.5*dt);
    dem_sweep_bodies(&p->particles, &p->recipe.bodies, 0.5*dt, window, p->ledger.open ? &p->ledger : NULL);
    dem_phases_end(&p->phases, DEM_PHASE_BODIES);
    for (int64_t k = 1; k <= steps; k++)
    {
        const double since = p->time;

        p->time = start + (double)k*dt;
        DEM_TRY(step(p, dt, k < steps ? dt : 0.5*dt, since, &status));
        DEM_TRY(sample(p));
    }
    DEM_TRY(agree(p, status, none));
    dem_bodies_close(&p->particles);
    dem_phases_leave(&p->phases);
    return DEM_OK;
}
