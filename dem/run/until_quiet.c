/*
 * until_quiet.c -- time/untilQuiet: test whether the particles have been at rest for long enough.
 *
 *     untilQuiet { kinetic 1e-6; moving 0.01; imbalance 0.01; lasting 0.1; }
 *
 * At rest, in one test:
 *   1. at most the fraction `moving` of the particles have more kinetic energy (dem_count_moving) than
 *      `kinetic` times the mean energy of falling by the mean diameter, or than a particle of the mean
 *      mass at `speed`. It is a fraction and not a mean, because without rolling resistance a few spheres
 *      may roll for ever;
 *   2. since the last test the net force on all particles was at most `imbalance` times their
 *      weight, |P - P'| <= imbalance M |g| (t - t'), with P the momentum. A soft tall bed swings:
 *      at the turning point all particles are slow at once, but their weight is not carried.
 *
 *   3. all streams and groups have inserted their particles. In a run with stages this concerns those that
 *      have begun; while no particle is free to move, also those whose beginning is known. Without such a
 *      particle, and none to come, a stage has rest.
 *
 * A clump counts once, with its mass, in the mean, too.
 *
 * All must hold for `lasting`. Its default is the longer of the fall by the height of the bed and
 * the period of its slowest elastic mode,
 *
 *     sqrt(2 H/|g|) max(1, 4 sqrt(o))                                                          [s]
 *
 *   H   extent of the moving particles along g, and a mean diameter                            [m]
 *   o   largest overlap since the last test, of a diameter                                     [1]
 *
 * The second is the period of a column fixed at its foot, 4 H/c: under its weight it is shortened by
 * u = |g| H^2/(2 c^2), so that H/c = sqrt(2 u/|g|), and u <= o H.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "core/error.h"
#include "core/vec.h"
#include "records/totals.h"
#include "input/dictionary.h"
#include "ranks/collect.h"
#include "sources/flows.h"
#include <fenv.h>
#include <float.h>
#include <math.h>
#include <string.h>

/* Without gravity there is no energy of falling to compare with, and no time of falling. */
int dem_quiet_check(const struct dem *d, const struct dem_quiet *q)
{
    double g[3];
    const int any = dem_gravity_acceleration(d, g) && dem_vec_dot(g, g) > 0.0;

    DEM_REQUIRE(!q->wanted || any || (q->speed > 0.0 && q->lasting > 0.0), DEM_ERROR_INPUT,
                "time/untilQuiet compares with the energy of falling by a diameter, but there is "
                "no gravity; give speed and lasting, or add gravity");
    return DEM_OK;
}

/* Rounded to a power of 2, so that a restart with other particles has the same windows. */
int64_t dem_quiet_tests(const struct dem *d, const struct dem_quiet *q, double interval)
{
    const double radius = dem_sim_max_radius(d);
    double g[3] = {0.0, 0.0, 0.0};

    if (!q->wanted)
    {
        return 1;
    }
    if (q->lasting > 0.0)
    {
        return (int64_t)fmax(1.0, fmin(0x1p53, ceil(5.0*interval/q->lasting)));
    }
    (void)dem_gravity_acceleration(d, g);
    const double fall = radius > 0.0 ? sqrt(2.0*radius/dem_vec_norm(g)) : interval;

    return (int64_t)exp2(fmax(0.0, fmin(30.0, rint(log2(interval/fall)))));
}

static double default_lasting(struct dem *d, const struct dem_totals *t, const double g[3])
{
    const double size = dem_vec_norm(g);
    const double diameter = t->weight > 0.0 ? t->fall_energy/t->weight : 0.0;
    const double high = dem_totals_extent(&d->state, g) + diameter;

    return sqrt(2.0*high/size)*fmax(1.0, 4.0*sqrt(t->largest_overlap));
}

/* 1 when the net force since the last test is small. */
static int balanced(const struct dem_quiet *q, const struct dem_totals *t)
{
    double net[3];

    dem_vec_minus(t->momentum, q->momentum, net);
    return t->weight == 0.0
        || (t->time > q->tested
            && dem_vec_norm(net) <= q->imbalance*t->weight*(t->time - q->tested));
}

/* 1 when a wall that is moved by force has more energy than a particle at rest may have, or a servo
   moves faster. */
static int walls_move(const struct dem *d, const struct dem_quiet *q, const struct dem_totals *t)
{
    const double n = t->bodies > 0 ? (double)t->bodies : 1.0;
    const double energy = q->speed > 0.0 ? 0.5*t->mass/n*q->speed*q->speed
                                         : q->kinetic*t->fall_energy/n;
    int moves = 0;

    for (int k = 0; k < d->state.walls.walls; k++)
    {
        const struct dem_wall_body *const b = dem_walls_body(&d->state.walls, k);

        moves |= b && (dem_wall_body_kinetic(b) > energy
                       || (b->kind == DEM_WALL_BODY_SERVO
                           && 0.5*t->mass/n*b->state.v[0]*b->state.v[0] > energy));
    }
    return moves;
}

int dem_quiet_test(struct dem *d, struct dem_quiet *q, const struct dem_totals *t)
{
    const double n = t->bodies > 0 ? (double)t->bodies : 1.0;
    double g[3];
    fenv_t caller;

    if (!q->wanted)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_count_moving(d,
                             q->speed > 0.0 ? 0.5*t->mass/n*q->speed*q->speed
                                            : q->kinetic*t->fall_energy/n,
                             &q->move));
    feholdexcept(&caller);
    const int falls = dem_gravity_acceleration(d, g) && t->weight > 0.0;

    q->wait = q->lasting > 0.0 || !falls ? q->lasting : default_lasting(d, t, g);
    const int staged = d->scene.stages.n > 0, empty = staged && !dem_totals_any_free(&d->state),
              awaits = dem_flows_insert_by(&d->state, staged && !empty ? t->time : DBL_MAX),
              rests = !awaits && !walls_move(d, q, t)
                   && (empty || ((double)q->move <= q->moving*(double)t->bodies && balanced(q, t)));

    q->since = !rests ? INFINITY : isfinite(q->since) ? q->since : t->time;
    q->reached = t->time - q->since >= q->wait*(1.0 - 1e-9);
    q->tested = t->time;
    memcpy(q->momentum, t->momentum, sizeof q->momentum);
    fesetenv(&caller);
    return dem_collect_status(&d->state.decomposition);
}
