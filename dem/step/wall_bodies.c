/*
 * wall_bodies.c -- sum the contacts of walls that are moved by force, over all ranks, and kick these
 * walls.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/wall_bodies.h"
#include "core/error.h"
#include "core/vec.h"
#include "particles/clump.h"
#include "ranks/collect.h"
#include "records/energy_balance.h"
#include "records/totals.h"
#include "records/wall_statistics.h"
#include "walls/wall_rotation.h"
#include <math.h>
#include <string.h>

/* Call with each wall that has a body. */
#define FOR_BODIES(all, k, body) \
    for (int k = 0; k < (all)->walls; k++) \
        for (struct dem_wall_body *body = dem_walls_body(all, k); body; body = NULL)

/* ---- drift and kick -------------------------------------------------------------------------- */

/* Energies of walls are the same on all ranks: the first one counts them. */
static void count_work(struct dem_state *state, const struct dem_wall_body_work *w)
{
    struct dem_energy_balance *const l = state->energy_balance;

    if (l->open && state->decomposition.rank == 0)
    {
        dem_energy_balance_add(&l->sum[DEM_ENERGY_BALANCE_LOADS], w->loads);
        dem_energy_balance_add(&l->sum[DEM_ENERGY_BALANCE_LOST_WALLS], w->lost);
        /* without rows the work of walls on particles misses this half kick, too */
        dem_energy_balance_add(&l->sum[DEM_ENERGY_BALANCE_WALLS],
                               state->lists_state == DEM_NEIGHBORS_NONE ? 0.0 : w->contacts);
    }
}

void dem_wall_bodies_drift(struct dem_state *state)
{
    struct dem_wall_body_work w = {0.0, 0.0, 0.0};

    FOR_BODIES(&state->walls, k, b)
    {
        dem_wall_body_drift(b, state->dt, &w);
    }
    count_work(state, &w);
}

/* Outside of its times, and while the wall is absent. */
static int rests(const struct dem_state *state, const struct dem_wall *of,
                 const struct dem_wall_body *b)
{
    return of->absent || state->time < b->start || state->time >= b->end;
}

static void kick_all(struct dem_state *state, double kick, struct dem_wall_body_work *w)
{
    struct dem_wall_body_kick in = {.time = state->time, .h = kick, .dt = state->dt};

    dem_interaction_table_gravity(&state->interaction_table, in.gravity);
    FOR_BODIES(&state->walls, k, b)
    {
        const struct dem_wall *const of = &state->walls.wall[k];

        in.rests = rests(state, of, b);
        dem_pose_point(&state->walls.frame[of->frame].pose, b->centre, in.centre);
        /* it keeps its velocity until a sweep has summed its contacts after it has appeared or has got
           its motion at a restart */
        if (in.rests || b->state.summed != DEM_WALL_BODY_UNKNOWN)
        {
            dem_wall_body_kick(b, &in, w);
        }
    }
}

void dem_wall_bodies_kick(struct dem_state *state, double kick)
{
    struct dem_wall_body_work w = {0.0, 0.0, 0.0};

    kick_all(state, kick, &w);
    count_work(state, &w);
}

/* ---- backup ---------------------------------------------------------------------------------- */

static void swap(struct dem_walls *w)
{
    FOR_BODIES(w, k, b)
    {
        const struct dem_wall_body_state state = b->state;

        b->state = b->backup;
        b->backup = state;
    }
}

void dem_wall_bodies_backup(struct dem_walls *w)
{
    FOR_BODIES(w, k, b)
    {
        b->backup = b->state;
    }
}

void dem_wall_bodies_kick_backup(struct dem_state *state, double kick)
{
    swap(&state->walls);
    dem_wall_bodies_kick(state, kick);
    swap(&state->walls);
}

void dem_wall_bodies_restore(struct dem_walls *w)
{
    FOR_BODIES(w, k, b)
    {
        b->state = b->backup;
    }
}

/* ---- sums ------------------------------------------------------------------------------------ */

void dem_wall_bodies_begin_sweep(struct dem_walls *w)
{
    FOR_BODIES(w, k, b)
    {
        for (int s = 0; s < DEM_WALL_BODY_SUMS; s++)
        {
            dem_binned_sum_clear(&b->sum[s]);
        }
    }
}

/* Squared lever arm of a contact about the axis or the centre of a rotation [m2]. */
static double squared_arm(const struct dem_wall_body *b, const double point[3])
{
    double centre[3], away[3], across[3];

    dem_wall_body_centre(b, centre);
    dem_vec_minus(point, centre, away);
    if (b->rotation.axes == 3)
    {
        return dem_vec_dot(away, away);
    }
    dem_vec_cross(b->rotation.axes == 1 ? b->rotation.axis : b->axis[0], away, across);
    return dem_vec_dot(across, across);
}

void dem_wall_bodies_add_batch(struct dem_state *state, const struct dem_contact_batch *b,
                               const struct dem_effect_list *effects, uint32_t row, int rows)
{
    for (int c = 0; c < rows; c++)
    {
        const struct dem_pair *const q = dem_contacts_pair(&state->contacts, row + (uint32_t)c);
        struct dem_wall_body *const body = dem_walls_body(
            &state->walls, state->walls.facet[dem_pairs_facet(&state->pairs, q->j)].wall);

        if (body && b->touching[c] > 0.0)
        {
            const struct dem_particle *const i = &state->particles.record[q->i];
            /* of a force ~ overlap^p: the tangent is p times the secant */
            const double k = effects->pair.exponent*b->kn[c],
                         square = squared_arm(body, state->touches.touch[q->j].point),
                         arm = body->kind == DEM_WALL_BODY_HINGE ? square : 1.0,
                         turning = body->rotation.axes > 0 ? square*k : 0.0,
                         mass = i->inverse_mass > 0.0 ? 1.0/i->inverse_mass : i->mass;

            dem_binned_sum_add(&body->sum[1],
                               (const double[DEM_BINNED_SUMS]){
                                   arm*k, arm*sqrt(k*mass), arm*b->eta[c], 1.0, 2.0*i->radius,
                                   turning});
        }
    }
}

/* Sum the terms of a body over all ranks. */
static void reduce(struct dem_state *state, int wall, struct dem_wall_body *b,
                   double total[DEM_WALL_BODY_TERMS])
{
    struct dem_sum sum[DEM_WALL_BODY_TERMS];

    dem_wall_statistics_sum_forces(state, wall, 1.0, &b->sum[0]);
    for (int s = 0; s < DEM_WALL_BODY_SUMS; s++)
    {
        dem_binned_sum_flush(&b->sum[s]);
        memcpy(sum + s*DEM_BINNED_SUMS, b->sum[s].sum, sizeof b->sum[s].sum);
    }
    dem_totals_reduce_sums(state, sum, DEM_WALL_BODY_TERMS, total);
}

static void take_sums(struct dem_wall_body *b, const double sum[DEM_WALL_BODY_TERMS], double time,
                      int absent)
{
    struct dem_wall_body_state *const s = &b->state;
    double centre[3], moment[3];

    dem_wall_body_centre(b, centre);
    dem_vec_cross(centre, sum, moment);
    dem_vec_minus(sum + 3, moment, s->torque);
    for (int k = 0; k < b->axes; k++)
    {
        s->force[k] = dem_vec_dot(b->axis[k], b->kind == DEM_WALL_BODY_HINGE ? s->torque : sum);
    }
    s->stiffness = sum[DEM_WALL_BODY_STIFFNESS];
    s->impedance = sum[DEM_WALL_BODY_IMPEDANCE];
    s->dashpot = sum[DEM_WALL_BODY_DASHPOT];
    s->contacts = sum[DEM_WALL_BODY_CONTACTS];
    s->diameter = s->contacts > 0.0 ? sum[DEM_WALL_BODY_DIAMETERS]/s->contacts : 0.0;
    s->turning = sum[DEM_WALL_BODY_TURNING];
    s->summed = absent ? DEM_WALL_BODY_UNKNOWN : DEM_WALL_BODY_SWEPT;
    if (absent)
    {
        s->hold = s->height = s->near_time = s->free_path = 0.0;
    }
    s->free_since = s->contacts > 0.0 || s->free_path == 0.0 ? time : s->free_since;
}

/* ---- limits ---------------------------------------------------------------------------------- */

/* Way of a servo that meets nothing, in diameters of the largest particle. */
static const double max_free_path = 200.0;

static int check_rotation(const struct dem_state *state, const struct dem_wall *of,
                      const struct dem_wall_body *b)
{
    const double dt = state->dt, K = b->state.turning, least = K*dt*dt/DEM_WALL_BODY_MAX_SWING,
                 I = dem_wall_rotation_least_inertia(&b->rotation);
    double w[3];

    dem_wall_rotation_spin(b, w);
    const double spin = dem_vec_norm(w);

    DEM_REQUIRE(I >= least, DEM_ERROR_NUMBER,
                "wall %s: %.3g kg m2 on contacts of %.3g N m swings too fast for the step %.3g s; use at least "
                "%.3g kg m2, or a smaller time/step", of->name, I, K, dt, least);
    DEM_REQUIRE(spin*dt <= DEM_CLUMP_MAX_TURN, DEM_ERROR_NUMBER,
                "wall %s turns by %.3g rad in a step of %.3g s, at %.3g 1/s; the limit is %g rad; use a time/step of "
                "at most %.3g s", of->name, spin*dt, dt, spin, DEM_CLUMP_MAX_TURN, DEM_CLUMP_MAX_TURN/spin);
    return DEM_OK;
}

static int check_mass(const struct dem_state *state, const struct dem_wall *of,
                      const struct dem_wall_body *b)
{
    const double dt = state->dt, K = b->state.stiffness, least = K*dt*dt/DEM_WALL_BODY_MAX_SWING;
    const int hinge = b->kind == DEM_WALL_BODY_HINGE;

    DEM_REQUIRE(b->mass >= least, DEM_ERROR_NUMBER,
                "wall %s: %.3g %s on contacts of %.3g %s swings too fast for the step %.3g s; use at "
                "least %.3g %s", of->name, b->mass, hinge ? "kg m2" : "kg", K, hinge ? "N m" : "N/m",
                dt, least, hinge ? "kg m2, or a smaller time/step" : "kg, or type servo");
    return b->rotation.axes > 0 ? check_rotation(state, of, b) : DEM_OK;
}

static int check_servo(const struct dem_state *state, const struct dem_wall *of,
                       const struct dem_wall_body *b)
{
    const struct dem_wall_body_state *const s = &b->state;

    DEM_REQUIRE(s->free_path <= max_free_path*2.0*state->pairs.max_radius, DEM_ERROR_NUMBER,
                "wall %s has met nothing over %.3g m since %.6g s; place it nearer, or turn its axis "
                "round", of->name, s->free_path, s->free_since);
    const double least = s->dashpot + 0.5*s->stiffness*state->dt;

    DEM_REQUIRE(b->damping < 0.0 || b->damping > least, DEM_ERROR_NUMBER,
                "wall %s: damping %.3g kg/s is below %.3g kg/s, the damping of its contacts and half of "
                "their stiffness times the step, so that it swings; use more, or leave it out",
                of->name, b->damping, least);
    return DEM_OK;
}

/* The servo has come near its target: from now on it makes up for an offset. */
static void begin_to_hold(struct dem_state *state, struct dem_wall_body *b)
{
    double target[DEM_TIME_TABLE_COLUMNS];

    dem_wall_body_load(b, state->time, target);
    const double wanted = target[0]*b->area;

    if (b->state.height == 0.0 && b->state.contacts > 0.0
        && dem_wall_body_is_near(b, wanted))
    {
        b->state.height = dem_totals_extent(state, b->axis[0]) + b->state.diameter;
    }
}

int dem_wall_bodies_sum(struct dem_state *state)
{
    int status = DEM_OK;

    FOR_BODIES(&state->walls, k, b)
    {
        const struct dem_wall *const of = &state->walls.wall[k];
        double total[DEM_WALL_BODY_TERMS];

        reduce(state, k, b, total);
        take_sums(b, total, state->time, of->absent);
        if (b->kind == DEM_WALL_BODY_SERVO)
        {
            begin_to_hold(state, b);
        }
        status = status || rests(state, of, b) ? status
                 : b->kind == DEM_WALL_BODY_SERVO ? check_servo(state, of, b)
                                                  : check_mass(state, of, b);
    }
    return status;
}
