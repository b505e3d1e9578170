/*
 * pause.c -- time/pauseAtRest: mechanics are paused while the particles rest, and resumed when
 * something moves.
 *
 *     pauseAtRest { kinetic 1e-6; moving 0.01; imbalance 0.01; lasting 0.1; step auto; }
 *
 * A bed conducts heat for hours, in mechanical steps of microseconds. The test of rest is that of
 * untilQuiet (until_quiet.c). In a pause every particle that is free is frozen, with the flag
 * DEM_PARTICLE_PAUSED, and its velocity and spin are zero; contacts, forces and history stay. Only
 * particle scalars change, so that the step is bounded by the effects that change them.
 *
 * Mechanics are resumed, from rest, when something begins or ends that the scene has a time for: the
 * motion of a wall, a stream, a force. Advances end at these times, and where the condition of a wall
 * for a scalar begins or ends, so that no long step steps over one. There is no pause while a wall
 * moves or a stream inserts, and the test of rest begins anew after each of these times.
 *
 * Forces that change though nothing moves would not be seen; scenes with such effects are refused:
 * forces that depend on a scalar that changes (liquid bridges), `changes_at_rest` of the effect.
 *
 * A snapshot holds the flags, and the test of rest as one row behind those of streams and outlets.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/internal.h"
#include "run/pause_events.h"
#include "core/error.h"
#include "core/vec.h"
#include "records/energy_balance.h"
#include "records/totals.h"
#include "input/dictionary.h"
#include "ranks/collect.h"
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char entry[] = "pauseAtRest";

/* ---- entry ----------------------------------------------------------------------------------- */

static int read_step(struct dem *d, const struct dem_dict *dict)
{
    const char *step;

    DEM_TRY(dem_dict_word_or(dict, "step", "auto", &step));
    if (strcmp(step, "auto") != 0)
    {
        DEM_TRY(dem_dict_number(dict, "step", "s", &d->pause.scene_step));
        DEM_REQUIRE(d->pause.scene_step > 0.0, DEM_ERROR_INPUT,
                    "%s: step %g s; give a number above 0, or auto", dem_dict_where(dict),
                    d->pause.scene_step);
    }
    return DEM_OK;
}

int dem_pause_enable(struct dem *d, int *wanted)
{
    const struct dem_dict *time, *dict = NULL;

    *wanted = 0;
    DEM_TRY(dem_api_require_unchecked(d, "dem_pause_enable"));
    DEM_REQUIRE(d->dict, DEM_ERROR_STATE, "dem_pause_enable comes after the scene has been read");
    DEM_TRY(dem_api_read_quiet(d, entry, &d->pause.rest));
    DEM_TRY(dem_dict_sub_if(d->dict, "time", &time));
    DEM_TRY(time ? dem_dict_sub_if(time, entry, &dict) : DEM_OK);
    *wanted = d->pause.rest.wanted;
    if (!*wanted)
    {
        return DEM_OK;
    }
    DEM_REQUIRE(!dem_dict_has(time, "untilQuiet"), DEM_ERROR_INPUT, "%s: both untilQuiet, which ends "
                "the run at rest, and pauseAtRest, which continues it; keep one",
                dem_dict_where(time));
    return read_step(d, dict);
}

int64_t dem_pause_tests(const struct dem *d, double interval)
{
    return dem_quiet_tests(d, &d->pause.rest, interval);
}

double dem_pause_until(const struct dem *d)
{
    return d->state.paused ? dem_events_next(&d->state, d->state.time, 0).time : INFINITY;
}

/* ---- check ----------------------------------------------------------------------------------- */

static int refuse_effects(const struct dem_effect_list *list)
{
    for (int k = 0; k < list->entries; k++)
    {
        const struct dem_effect *const e = list->entry[k].effect;

        for (int m = 0; e->stage < DEM_STAGE_SCALAR && e->scalars && e->scalars[m]; m++)
        {
            DEM_REQUIRE(!(e->scalars[m]->flags & DEM_SCALAR_RATE), DEM_ERROR_INPUT,
                        "time/%s: the force of effects/%s depends on %s, which may change while "
                        "mechanics are paused; leave out one of the two",
                        entry, e->name, e->scalars[m]->name);
        }
        DEM_REQUIRE(!e->changes_at_rest || !e->changes_at_rest(list->entry[k].settings),
                    DEM_ERROR_INPUT,
                    "time/%s: the force of effects/%s changes with time, also where nothing moves; "
                    "leave out one of the two", entry, e->name);
    }
    return DEM_OK;
}

static int refuse_motion(const struct dem *d)
{
    const struct dem_state *const p = &d->state;

    for (int w = 0; w < p->walls.walls; w++)
    {
        DEM_REQUIRE(!dem_events_wall_moves(p, &p->walls.wall[w], 1), DEM_ERROR_INPUT,
                    "time/%s: wall %s moves from the start to the end, so mechanics never pause; "
                    "leave the entry out, or give its motion an end", entry, p->walls.wall[w].name);
    }
    for (int k = 0; k < d->scene.streams.streams; k++)
    {
        const struct dem_stream *const s = &d->scene.streams.stream[k];

        DEM_REQUIRE(s->start > 0.0 || s->end < INFINITY || s->count < INT64_MAX ||
                        s->mass < INFINITY,
                    DEM_ERROR_INPUT, "time/%s: the stream insert/%s never ends, so mechanics never "
                    "pause; leave the entry out, or give the stream an end", entry, s->name);
    }
    DEM_REQUIRE(d->scene.streams.streams + d->scene.streams.outlets + 2 <= DEM_SNAPSHOT_FLOWS,
                DEM_ERROR_INPUT, "time/%s: %d streams and outlets are too many for a snapshot with "
                "the test of rest, the limit is %d; merge some of them", entry,
                d->scene.streams.streams + d->scene.streams.outlets, DEM_SNAPSHOT_FLOWS - 2);
    return DEM_OK;
}

static int choose_step(struct dem *d)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;
    const double given = d->pause.scene_step;

    d->pause.step = given > 0.0 ? given : r->scalar_limit;
    DEM_REQUIRE(given <= r->scalar_limit || d->scene.force, DEM_ERROR_INPUT,
                "time/%s/step %g s exceeds %.3g s (%s); use at most that, or time/force yes", entry,
                given, r->scalar_limit, r->scalar_why);
    return DEM_OK;
}

int dem_api_check_pause(struct dem *d)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;
    int changes = 0;

    d->pause.moving_step = d->step;
    if (!d->pause.rest.wanted)
    {
        return DEM_OK;
    }
    for (int k = 0; k < r->scalars; k++)
    {
        changes |= (r->scalar[k]->flags & DEM_SCALAR_RATE) != 0;
    }
    DEM_REQUIRE(changes, DEM_ERROR_INPUT,
                "time/%s: no effect changes a particle scalar, such as the temperature, so nothing "
                "is left to compute while mechanics are paused; add one (conduction), or end the "
                "run at rest by untilQuiet", entry);
    DEM_REQUIRE(!d->with_fluid || d->scene.fluid.given, DEM_ERROR_INPUT,
                "time/%s: the coupled fluid moves particles at any time, so mechanics are not "
                "paused; leave the entry out", entry);
    DEM_TRY(dem_api_check_quiet(d, entry, &d->pause.rest));
    for (int c = 0; c < r->classes; c++)
    {
        DEM_TRY(refuse_effects(&r->list[c]));
    }
    DEM_TRY(refuse_effects(&r->bodies));
    DEM_TRY(refuse_motion(d));
    return choose_step(d);
}

/* ---- pause and resume ------------------------------------------------------------------------ */

static void begin_pause(struct dem *d)
{
    struct dem_state *const p = &d->state;

    for (size_t i = 0; i < p->particles.n; i++)
    {
        struct dem_particle *const r = &p->particles.record[i];

        if (!(r->flags & DEM_PARTICLE_FROZEN))
        {
            if (p->energy_balance->open)
            {
                dem_energy_balance_particle_paused(p->energy_balance, r);
            }
            r->flags |= DEM_PARTICLE_FROZEN | DEM_PARTICLE_PAUSED;
            r->inverse_mass = r->inverse_inertia = 0.0;
            memset(r->v, 0, sizeof r->v);
            memset(r->w, 0, sizeof r->w);
        }
    }
    p->paused = 1;
    p->stale = p->stale == 2 ? 2 : 1;    /* ghosts have these values, too */
    d->step = d->pause.step;
}

/* Each window adds the added mass. */
static void end_pause(struct dem *d)
{
    struct dem_state *const p = &d->state;

    for (size_t i = 0; i < p->particles.n; i++)
    {
        struct dem_particle *const r = &p->particles.record[i];

        if (r->flags & DEM_PARTICLE_PAUSED)
        {
            r->flags &= (uint16_t)~(DEM_PARTICLE_FROZEN | DEM_PARTICLE_PAUSED);
            r->inverse_mass = 1.0/r->mass;
            r->inverse_inertia = 1.0/(0.4*r->mass*r->radius*r->radius);
        }
    }
    p->paused = 0;
    p->half_step_ahead = 0;    /* of particles at rest */
    p->stale = p->stale == 2 ? 2 : 1;
    d->step = d->pause.moving_step;
}

/* The test of rest begins anew. */
static void forget_rest(struct dem *d)
{
    struct dem_quiet *const q = &d->pause.rest;

    q->since = INFINITY;
    q->reached = 0;
}

int dem_paused(const struct dem *d)
{
    return d->state.paused;
}

int dem_resume(struct dem *d)
{
    struct dem_quiet *const q = &d->pause.rest;

    DEM_REQUIRE(d->is_set_up, DEM_ERROR_STATE, "dem_resume comes after dem_setup");
    if (d->state.paused)
    {
        end_pause(d);
        forget_rest(d);
        q->tested = d->pause.updated = d->state.time;
        memset(q->momentum, 0, sizeof q->momentum);
        d->pause.overlap = 0.0;
    }
    return DEM_OK;
}

static int resume_when_due(struct dem *d)
{
    const struct dem_event e = dem_events_next(&d->state, d->pause.updated, 1);
    const int begins = e.time <= dem_events_after(d->state.time);

    if (!begins && !dem_events_act(&d->state))
    {
        d->pause.updated = d->state.time;
        return DEM_OK;
    }
    snprintf(d->pause.text, sizeof d->pause.text, "mechanics resumed at t %.9g s: %s",
             d->state.time, begins ? e.what : "a wall moves, or a stream inserts");
    return dem_resume(d);
}

static void tell_pause(struct dem *d, const struct dem_totals *t)
{
    const struct dem_event e = dem_events_next(&d->state, d->state.time, 1);
    char until[240] = "the end";

    if (isfinite(e.time))
    {
        snprintf(until, sizeof until, "t %.9g s, when %s", e.time, e.what);
    }
    snprintf(d->pause.text, sizeof d->pause.text,
             "mechanics paused at t %.9g s: %lld of %lld particles move; kinetic energy %.3g J is "
             "removed; steps of up to %.3g s until %s",
             d->state.time, (long long)d->pause.rest.move, (long long)t->particles, t->kinetic,
             d->pause.step, until);
}

static int pause_when_at_rest(struct dem *d, const struct dem_totals *totals)
{
    const struct dem_event e = dem_events_next(&d->state, d->pause.updated, 1);
    struct dem_totals t = *totals;

    t.largest_overlap = d->pause.overlap;
    d->pause.overlap = 0.0;
    DEM_TRY(dem_quiet_test(d, &d->pause.rest, &t));
    d->pause.updated = d->state.time;
    if (e.time <= dem_events_after(d->state.time) || dem_events_act(&d->state))
    {
        forget_rest(d);
    }
    if (d->pause.rest.reached)
    {
        tell_pause(d, &t);
        begin_pause(d);
    }
    return DEM_OK;
}

int dem_pause_update(struct dem *d, const struct dem_totals *t, const char **text)
{
    fenv_t caller;
    int status = DEM_OK;

    *text = d->pause.text;
    d->pause.text[0] = '\0';
    DEM_REQUIRE(d->is_set_up, DEM_ERROR_STATE, "dem_pause_update comes after dem_setup");
    if (!d->pause.rest.wanted || d->state.half_step_ahead)
    {
        return DEM_OK;
    }
    feholdexcept(&caller);
    status = d->state.paused ? resume_when_due(d) : pause_when_at_rest(d, t);
    fesetenv(&caller);
    return status;
}

/* ---- snapshots ------------------------------------------------------------------------------- */

enum
{
    ROW_KIND = 4,
    AT_REST = 1, TESTED = 2    /* the numbers that are finite, as `count` of the row */
};

void dem_api_save_rest(const struct dem *d, struct dem_snapshot *s)
{
    const struct dem_quiet *const q = &d->pause.rest;
    struct dem_snapshot_flow *const row = &s->flow[s->flows];

    if (!q->wanted)
    {
        return;
    }
    memset(row, 0, sizeof *row);
    snprintf(row->name, sizeof row->name, "%s", entry);
    row->kind = ROW_KIND;
    row->count = (isfinite(q->since) ? AT_REST : 0) | (isfinite(q->tested) ? TESTED : 0);
    row->since = isfinite(q->since) ? q->since : 0.0;
    row->last = isfinite(q->tested) ? q->tested : 0.0;
    row->start = d->pause.updated;
    row->energy = d->pause.overlap;
    memcpy(row->momentum, q->momentum, sizeof row->momentum);
    s->flows++;
}

static void continue_test(struct dem *d, const struct dem_snapshot_flow *row)
{
    struct dem_quiet *const q = &d->pause.rest;

    q->since = row->count & AT_REST ? row->since : INFINITY;
    q->tested = row->count & TESTED ? row->last : -INFINITY;
    d->pause.updated = row->start;
    d->pause.overlap = row->energy;
    memcpy(q->momentum, row->momentum, sizeof q->momentum);
}

/* A snapshot in which this run continues (not one from which another run starts) keeps the pause. */
int dem_api_resume_pause(struct dem *d)
{
    struct dem_state *const p = &d->state;
    const int continues = d->pause.rest.wanted && d->load_path[0] && !d->scene_start;
    double any[2] = {0.0, 0.0};

    for (size_t i = 0; i < p->particles.n; i++)
    {
        any[0] = p->particles.record[i].flags & DEM_PARTICLE_PAUSED ? 1.0 : any[0];
        any[1] = p->particles.record[i].flags & DEM_PARTICLE_DRIVEN ? 1.0 : any[1];
    }
    dem_totals_reduce_max(p, any, 2);
    DEM_REQUIRE(!d->pause.rest.wanted || any[1] == 0.0, DEM_ERROR_INPUT,
                "time/%s: there are driven particles, which move all the time, so mechanics never "
                "pause; leave the entry out", entry);
    d->pause.updated = p->time;
    p->energy_balance->pauses = d->pause.rest.wanted;
    if (any[0] > 0.0 && continues)
    {
        p->paused = 1;
        d->step = d->pause.step;
    }
    else if (any[0] > 0.0)
    {
        end_pause(d);
    }
    for (int64_t k = 0; continues && k < d->snapshot_flows.flows; k++)
    {
        if (d->snapshot_flows.flow[k].kind == ROW_KIND)
        {
            continue_test(d, &d->snapshot_flows.flow[k]);
        }
    }
    return dem_collect_status(&p->decomposition);
}
