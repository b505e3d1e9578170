/*
 * stage_tests.c -- the advance of a run with stages: windows of steps that end where a stage may end
 * and where a wall comes or goes; the test of the present stage after each.
 *
 * Tests of rest and of loads are made at multiples of a power of 2 in seconds, between two windows, where
 * the state is synchronous: a fifth of `lasting`, or the time of falling by a diameter; for a load
 * without lasting 100 steps. They depend on the state alone, which has the same bits on any number
 * of ranks; a snapshot has what they remember (case/stages.c).
 *
 * A coupled run tests at the end of each fluid step, which is one window.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "case/stages.h"
#include "core/error.h"
#include "core/vec.h"
#include "run/stage_tests.h"
#include "sources/flows.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* 1  of a step: times closer than this are the same */
static const double same_time = 1e-3;

enum
{
    LOAD_STEPS = 100,      /* between tests of a load without lasting, */
    LEAST_STEPS = 20       /* and at least */
};

/* ---- windows --------------------------------------------------------------------------------- */

/* s  between tests of the present stage */
static double choose_part(const struct dem *d, const struct dem_run_stage *s)
{
    double g[3];

    (void)dem_gravity_acceleration(d, g);
    const double lasting = s->until == DEM_UNTIL_LOAD ? s->lasting : s->quiet.lasting;
    const double fall = s->until == DEM_UNTIL_LOAD ? LOAD_STEPS*d->step
                                                   : sqrt(2.0*dem_sim_max_radius(d)/dem_vec_norm(g));
    const double part = lasting > 0.0 ? 0.2*lasting : fall;

    return exp2(rint(log2(fmax(part, LEAST_STEPS*d->step))));
}

static double sooner(const struct dem *d, double next, double at)
{
    const double near = same_time*d->step;

    return at > d->state.time + near && at < d->scene.stages.end - near ? fmin(next, at) : next;
}

/* When the present window ends [s], at the latest at the end of the advance. */
static double next_end(struct dem *d)
{
    struct dem_run_stages *const s = &d->scene.stages;
    double next = sooner(d, s->end, dem_walls_next_change(&d->state.walls, d->state.time));

    if (s->n > 0 && !isfinite(s->over))
    {
        const struct dem_run_stage *const now = &s->stage[s->present];

        next = sooner(d, next, now->begin + now->duration);
        next = sooner(d, next, now->begin + now->at_most);
        if (now->until)
        {
            s->part = s->part > 0.0 ? s->part : choose_part(d, now);
            next = sooner(d, next,
                          (floor(d->state.time/s->part + 1e-6) + 1.0)*s->part);
        }
    }
    return next;
}

/* ---- tests ----------------------------------------------------------------------------------- */

/* *why: what has ended the stage, or NULL. */
static int rests(struct dem *d, struct dem_run_stage *s, const char **why)
{
    struct dem_totals t;

    DEM_TRY(dem_totals(d, &t));
    d->state.limits.overlap = t.largest_overlap;    /* for the next call of the program */
    DEM_TRY(dem_quiet_test(d, &s->quiet, &t));
    *why = !s->quiet.reached ? NULL
           : dem_totals_any_free(&d->state) ? "the particles rest" : "no particle can move, and none is to come";
    return DEM_OK;
}

static int carries(struct dem *d, struct dem_run_stage *s, const char **why)
{
    double force[3], torque[3];

    DEM_TRY(dem_wall_load(d, s->wall_index, force, torque));
    const int directed = dem_vec_dot(s->direction, s->direction) > 0.0;
    const double load = directed ? dem_vec_dot(force, s->direction) : dem_vec_norm(force);
    const int there = s->within > 0.0 ? fabs(load - s->load) <= s->within*s->load : load >= s->load;

    s->since = !there ? INFINITY : isfinite(s->since) ? s->since : d->state.time;
    *why = there && d->state.time - s->since >= s->lasting*(1.0 - 1e-9) ? "the load is reached" : NULL;
    return DEM_OK;
}

static int is_test(const struct dem_run_stages *s, double time)
{
    const double number = time/s->part;

    return fabs(number - rint(number)) <= 1e-6;
}

/* Test the present stage; *why: what has ended it, or NULL. */
static int test_stage(struct dem *d, const char **why)
{
    struct dem_run_stages *const s = &d->scene.stages;
    struct dem_run_stage *const now = &s->stage[s->present];
    const double past = d->state.time + same_time*d->step - now->begin;

    *why = NULL;
    if (now->until && (d->coupled || is_test(s, d->state.time)))
    {
        DEM_TRY(now->until == DEM_UNTIL_QUIET ? rests(d, now, why) : carries(d, now, why));
    }
    *why = *why                    ? *why
           : past >= now->duration ? "its time is over"
           : past >= now->at_most  ? "atMost is over, without what it waited for"
                                   : NULL;
    return DEM_OK;
}

static void begin_next(struct dem *d, const char *why)
{
    struct dem_run_stages *const s = &d->scene.stages;
    struct dem_flows *const f = d->state.flows;

    if (s->present + 1 == s->n)
    {
        s->over = d->state.time;
        return;
    }
    dem_stages_begin(d, s->present + 1, d->state.time, why);
    for (int k = 0; k < d->scene.streams.streams; k++)
    {
        f->flow[k].start = d->scene.streams.stream[k].start;
        f->flow[k].end = d->scene.streams.stream[k].end;
    }
}

/* " lid", or " lid or gate": the walls that have come just now. */
static const char *name_walls(const struct dem_walls *w, char names[200])
{
    int n = 0;

    for (int k = 0; k < w->walls && n < 130; k++)
    {
        n += w->wall[k].came ? snprintf(names + n, 66, "%s %.60s", n > 0 ? " or" : "", w->wall[k].name) : 0;
    }
    return names;
}

/* A wall must not appear in particles. */
static int refuse_inside(struct dem *d)
{
    struct dem_state *const state = &d->state;
    char names[200] = "";
    int status = DEM_OK, clear = 1;

    for (int k = 0; k < state->walls.walls; k++)
    {
        state->walls.wall[k].absent += state->walls.wall[k].came ? 0 : 2;
    }
    for (size_t i = 0; i < state->particles.n && !status; i++)
    {
        struct dem_particle q = state->particles.record[i];

        q.radius *= 1.0 - 2.0*d->scene.max_start_overlap;
        status = dem_wall_search_is_clear(&state->pairs.wall_search, &state->walls, &q, &clear);
        if (!status && !clear)
        {
            status = dem_error(DEM_ERROR_INPUT, "wall%s appears at %g s (its entry `from`) where "
                               "particle %lld is, at (%g %g %g) m; let it appear later, or elsewhere",
                               name_walls(&state->walls, names), state->time, (long long)q.id, q.x[0], q.x[1], q.x[2]);
        }
    }
    for (int k = 0; k < state->walls.walls; k++)
    {
        state->walls.wall[k].absent -= state->walls.wall[k].came ? 0 : 2;
    }
    return dem_sim_agree(d, status);
}

static int change_walls(struct dem *d)
{
    struct dem_state *const state = &d->state;
    int came = 0;

    if (!dem_walls_come_and_go(&state->walls, state->time + same_time*d->step))
    {
        return DEM_OK;
    }
    dem_request_rebuild(state);
    dem_walls_move(&state->walls, state->time, 0.0);
    for (int k = 0; k < state->walls.walls; k++)
    {
        came |= state->walls.wall[k].came;
    }
    return came ? refuse_inside(d) : DEM_OK;
}

static int end_window(struct dem *d)
{
    struct dem_run_stages *const s = &d->scene.stages;
    const char *why;

    if (s->n > 0 && !isfinite(s->over))
    {
        DEM_TRY(test_stage(d, &why));
        if (why)
        {
            begin_next(d, why);
        }
    }
    return change_walls(d);
}

/* ---- advance --------------------------------------------------------------------------------- */

int dem_stages_advance(struct dem *d, double duration, int (*window)(struct dem *, double))
{
    struct dem_run_stages *const s = &d->scene.stages;
    const double end = d->state.time + duration;

    /* the rest of an advance that was stopped ends at the same number */
    s->end = d->state.window.half_step_ahead && fabs(end - s->end) <= same_time*d->state.dt ? s->end : end;
    for (;;)
    {
        const double next = d->coupled ? s->end : next_end(d);

        DEM_TRY(window(d, next - d->state.time));
        if (d->state.window.half_step_ahead)    /* stopped */
        {
            return DEM_OK;
        }
        DEM_TRY(end_window(d));
        if (next >= s->end)
        {
            return DEM_OK;
        }
    }
}

const char *dem_run_stage(const struct dem *d, int k, double *begin, const char **why)
{
    const struct dem_run_stages *const s = &d->scene.stages;
    const int there = k >= 0 && k < s->n;

    *begin = there ? s->stage[k].begin : INFINITY;
    *why = there ? s->stage[k].why : "";
    return there ? s->stage[k].name : NULL;
}

int dem_stages_over(const struct dem *d)
{
    return d->scene.stages.n > 0 && isfinite(d->scene.stages.over);
}

void dem_stages_rewind(struct dem *d)
{
    struct dem_run_stages *const s = &d->scene.stages;

    for (int k = 1; k < s->n; k++)
    {
        if (s->stage[k].begin > d->state.time && isfinite(s->stage[k].begin))
        {
            dem_stages_begin(d, k, INFINITY, "");
        }
    }
    for (s->present = 0; s->present + 1 < s->n && isfinite(s->stage[s->present + 1].begin); s->present++)
    {
    }
    s->over = s->over > d->state.time ? INFINITY : s->over;
    s->part = 0.0;
    if (s->n > 0)
    {
        s->stage[s->present].since = s->stage[s->present].quiet.since = INFINITY;
        s->stage[s->present].quiet.tested = -INFINITY;
    }
}
