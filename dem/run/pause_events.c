/*
 * pause_events.c -- the times of a scene at which walls, streams, forces and conditions of walls begin
 * and end.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/pause_events.h"
#include "sources/flows.h"
#include "ranks/dem_state.h"
#include <math.h>
#include <stdio.h>

double dem_events_after(double time)
{
    return time + 1e-12*fabs(time);
}

struct candidate
{
    double time;
    const char *kind, *name, *does;
};

static void consider(struct dem_event *e, const struct candidate *c)
{
    if (c->time > dem_events_after(e->from) && c->time < e->time)
    {
        e->time = c->time;
        snprintf(e->what, sizeof e->what, "%s %s %s", c->kind, c->name, c->does);
    }
}

static const struct dem_motion *motion_of(const struct dem_state *p, const struct dem_wall *w)
{
    const struct dem_motion *const m = w->frame >= 0 ? &p->walls.frame[w->frame].motion : NULL;

    return m && m->kind != DEM_MOTION_REST ? m : NULL;
}

static void consider_wall(struct dem_event *e, const struct dem_state *p, const struct dem_wall *w)
{
    const struct dem_motion *const m = motion_of(p, w);

    if (m)
    {
        consider(e, &(struct candidate){m->start, "wall", w->name, "begins to move"});
        consider(e, &(struct candidate){m->end, "wall", w->name, "comes to rest"});
    }
    for (int k = 0; !e->mechanics && w->scalars && k < p->interaction_table.scalars; k++)
    {
        const struct dem_wall_scalar *const s = &w->scalars[k];

        consider(e, &(struct candidate){s->start, "condition of wall", w->name, "begins"});
        consider(e, &(struct candidate){s->end, "condition of wall", w->name, "ends"});
    }
}

struct dem_event dem_events_next(const struct dem_state *p, double from, int mechanics)
{
    const struct dem_streams *const plan = p->flows->plan;
    struct dem_event e = {.from = from, .mechanics = mechanics, .time = INFINITY};

    for (int w = 0; w < p->walls.walls; w++)
    {
        consider_wall(&e, p, &p->walls.wall[w]);
    }
    for (int k = 0; plan && k < plan->streams; k++)
    {
        const struct dem_stream *const s = &plan->stream[k];
        const double start = dem_flows_stream_is_open(p, k) ? s->start : INFINITY;

        consider(&e, &(struct candidate){start, "stream", s->name, "begins"});
    }
    for (int k = 0; k < p->applied_forces.n; k++)
    {
        const struct dem_applied_force *const f = &p->applied_forces.force[k];

        consider(&e, &(struct candidate){f->start, "force", f->name, "begins"});
        consider(&e, &(struct candidate){f->end, "force", f->name, "ends"});
    }
    return e;
}

int dem_events_wall_moves(const struct dem_state *p, const struct dem_wall *w, int always)
{
    const struct dem_motion *const m = motion_of(p, w);

    return w->driven || w->moves ||
           (m && (always ? m->start <= 0.0 && m->end == INFINITY
                         : dem_events_after(p->time) >= m->start && dem_events_after(p->time) < m->end));
}

int dem_events_act(const struct dem_state *p)
{
    int moved = 0;

    for (int w = 0; w < p->walls.walls; w++)
    {
        moved |= dem_events_wall_moves(p, &p->walls.wall[w], 0);
    }
    for (int k = 0; p->flows->plan && k < p->flows->plan->streams; k++)
    {
        moved |= dem_flows_stream_acts(p, k);
    }
    return moved;
}
