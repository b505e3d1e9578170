/*
 * limits.c -- displacements of a drift; largest overlap and forces that are not a number, batch by
 * batch, and at the end of the sweep an error message if needed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/limits.h"
#include "core/error.h"
#include "core/math.h"
#include "laws/effect.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Largest overlap as a fraction of the smaller diameter; 1e30, above every limit, if a force is not
   a number. */
DEM_KERNEL
static double worst_of(const struct dem_contact_batch *restrict b)
{
    double max[DEM_LANES] = {0.0}, bad[DEM_LANES] = {0.0}, worst = 0.0;

    for (int c = 0; c < b->n; c += DEM_LANES)
    {
        for (int k = 0; k < DEM_LANES; k++)
        {
            const double fraction = 0.5*b->overlap[c + k]/b->min_radius[c + k];

            max[k] = dem_select(fraction > max[k], fraction, max[k]);
            bad[k] += (b->fn[c + k] + b->fx[c + k] + b->fy[c + k] + b->fz[c + k])*0.0;
        }
    }
    for (int k = 0; k < DEM_LANES; k++)
    {
        worst = max[k] > worst ? max[k] : worst;
        worst = bad[k] == 0.0 ? worst : 1e30;
    }
    return worst;
}

void dem_limits_check_record(struct dem_state *state, const struct dem_contact_workspace *t,
                             const uint32_t *pair, int rows)
{
    const double worst = worst_of(&t->batch);
    int lane = 0;

    if (worst <= state->limits.overlap)
    {
        return;
    }
    for (int c = 0; c < t->batch.n; c++)
    {
        const double force = t->batch.fn[c] + t->batch.fx[c] + t->batch.fy[c] + t->batch.fz[c];

        lane = force*0.0 != 0.0 || 0.5*t->batch.overlap[c]/t->batch.min_radius[c] == worst
                   ? c
                   : lane;
    }
    const struct dem_pair *const q =
        &state->contacts.pairs.pair[pair[lane < rows ? lane : rows - 1]];
    const struct dem_particle *const i = &state->particles.record[q->i];

    state->limits.overlap = worst;
    state->limits.lawless = !dem_effect_list_has_law(&state->interaction_table.list[q->class]);
    state->limits.i = i->id;
    state->limits.j = q->wall ? -1 - state->pairs.wall_facet[q->j].number
                              : state->particles.record[q->j].id;
    memcpy(state->limits.x, i->x, sizeof i->x);
}

/* The partners of the worst row, as text. */
static void partner_names(const struct dem_state *state, char *text, size_t size)
{
    const struct dem_limits *const w = &state->limits;

    if (w->j < 0)
    {
        snprintf(text, size, "particle %lld and wall %s", (long long)w->i,
                 state->walls.wall[dem_walls_with_facet(&state->walls, (int)(-1 - w->j))].name);
    }
    else
    {
        snprintf(text, size, "particles %lld and %lld", (long long)w->i, (long long)w->j);
    }
}

int dem_limits_check_status(const struct dem_state *state)
{
    const struct dem_limits *const w = &state->limits;
    char names[160];

    if (w->overlap <= w->overlap_limit)
    {
        return DEM_OK;
    }
    partner_names(state, names, sizeof names);
    DEM_REQUIRE(
        w->overlap < 1e29, DEM_ERROR_NUMBER,
        "the force between %s near (%g %g %g) m is not a number at step %lld; check their input, or the fluid "
        "around them",
        names, w->x[0], w->x[1], w->x[2], (long long)state->steps);
    DEM_REQUIRE(
        !w->lawless, DEM_ERROR_NUMBER,
        "%s near (%g %g %g) m pass through each other at time %g s: no contact law acts between them; add a normal law to "
        "effects, hertz {} for example",
        names, w->x[0], w->x[1], w->x[2], state->time);
    return dem_error(
        DEM_ERROR_NUMBER,
        "%s near (%g %g %g) m overlap by %.3g of a diameter at step %lld, the limit is %g; use a "
        "smaller step or a stiffer material, or raise time/maxOverlap",
        names, w->x[0], w->x[1], w->x[2], w->overlap, (long long)state->steps, w->overlap_limit);
}

/* ---- displacements --------------------------------------------------------------------------- */

/* m: displacement of walls in the last step towards which a particle may have moved, with two sides:
   behind a wall with one side it is found anyway. */
static double two_sided_displacement(const struct dem_walls *w)
{
    int moves = w->following > 0;

    for (int k = 0; k < w->frames; k++)
    {
        moves |= w->frame[k].triangles;
    }
    return moves ? w->displacement : 0.0;
}

static double min_radius_of(const struct dem_state *state)
{
    double min_radius = INFINITY;

    for (int c = 0; c < state->interaction_table.classes; c++)
    {
        const int material =
            (int)(state->interaction_table.list[c].pair.a - state->interaction_table.material);

        min_radius = state->interaction_table.list[c].entries > 0
                         ? fmin(min_radius, state->interaction_table.min_radius[material])
                         : min_radius;
    }
    return min_radius;
}

double dem_limits_max_wall_displacement(const struct dem_state *state)
{
    return min_radius_of(state);
}

double dem_limits_max_speed(const struct dem_state *state)
{
    const double limit = state->limits.speed_limit > 0.0 ? state->limits.speed_limit : INFINITY;

    return fmin(fmin(limit, dem_particle_max_speed),
                (min_radius_of(state) - two_sided_displacement(&state->walls))/state->dt);
}

static int check_turns(const struct dem_state *state)
{
    const struct dem_clumps *const c = &state->clumps;

    /* the drift has found the fastest spin; look for its body only where it is too fast */
    const int any = sqrt(c->max_spin_square)*state->dt > DEM_CLUMP_MAX_TURN;

    for (size_t k = 0; k < c->n && any; k++)
    {
        struct dem_clump body;

        dem_clumps_body(c, k, &state->particles, &body);
        DEM_TRY(dem_clump_check_spin(&body, &state->particles.record[c->member[c->start[k]]], state->dt,
                                     DEM_ERROR_NUMBER));
    }
    return DEM_OK;
}

int dem_limits_check_displacements(const struct dem_state *state, double max_speed)
{
    const double light = dem_particle_max_speed, dt = state->dt;
    const double limit = state->limits.speed_limit > 0.0 ? state->limits.speed_limit : INFINITY;
    const double min_radius = min_radius_of(state);

    DEM_REQUIRE(
        state->walls.displacement <= min_radius, DEM_ERROR_NUMBER,
        "a wall moves by %.3g m in step %lld at time %g s; the limit is %g m, the radius of the smallest particle, or it may miss a "
        "contact; use a smaller time/step, or a slower motion",
        state->walls.displacement, (long long)state->steps, state->time, min_radius);
    const double wall = two_sided_displacement(&state->walls);

    for (size_t i = 0;
         (max_speed*dt + wall > min_radius || max_speed > limit || max_speed > light) &&
         i < state->particles.n;
         i++)
    {
        const struct dem_particle *const q = &state->particles.record[i];
        const double speed = sqrt(q->v[0]*q->v[0] + q->v[1]*q->v[1] + q->v[2]*q->v[2]);

        DEM_REQUIRE(!isnan(speed), DEM_ERROR_NUMBER,
                    "the velocity of particle %lld is not a number at step %lld; check the "
                    "forces on it, and the fluid around it",
                    (long long)q->id, (long long)state->steps);
        DEM_REQUIRE(
            speed <= limit, DEM_ERROR_NUMBER,
            "particle %lld at (%g %g %g) m has %g m/s in step %lld; the limit time/maxSpeed is %g m/s; check what accelerates it (%s), "
            "or raise the limit",
            (long long)q->id, q->x[0], q->x[1], q->x[2], speed, (long long)state->steps, limit,
            state->interaction_table.step_limit < dt*(1.0 - 1e-9)
                ? "the time step is forced above the limit of its laws"
                : "an impact, a wall, the fluid");
        DEM_REQUIRE(
            speed <= light, DEM_ERROR_NUMBER,
            "particle %lld at (%g %g %g) m has %g m/s in step %lld; the limit is %g m/s, the speed of light; "
            "use a smaller time/step, or check the forces on it",
            (long long)q->id, q->x[0], q->x[1], q->x[2], speed, (long long)state->steps, light);
        DEM_REQUIRE(
            speed*dt <= q->radius, DEM_ERROR_NUMBER,
            "particle %lld at (%g %g %g) m moves by %.3g m in step %lld, at %g m/s; its radius is %g m, which is the limit, "
            "or it may miss a contact; use a smaller time/step, or check the forces on it",
            (long long)q->id, q->x[0], q->x[1], q->x[2], speed*dt, (long long)state->steps, speed,
            q->radius);
        DEM_REQUIRE(
            speed*dt + wall <= q->radius, DEM_ERROR_NUMBER,
            "particle %lld at (%g %g %g) m moves by %.3g m in step %lld and a wall by %.3g m; the limit of the sum is %g m, "
            "its radius, or they may miss a contact; use a smaller time/step, or a slower motion",
            (long long)q->id, q->x[0], q->x[1], q->x[2], speed*dt, (long long)state->steps, wall,
            q->radius);
    }
    return check_turns(state);
}
