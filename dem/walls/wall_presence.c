/*
 * wall_presence.c -- walls that come or go during a run: gates, lids.
 *
 *     gate { type plane; ...; until 0.5; }      there before 0.5 s
 *     lid  { type plane; ...; from press; }     there since the stage `press` has begun
 *
 * A wall that is not there keeps its facets and their numbers; the search for wall neighbors leaves
 * them out. Walls come and go between two windows of steps (run/stage_tests.c). Contacts with a wall that
 * goes end when the lists are made anew.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/walls.h"
#include <math.h>

/* 1  of the time: a window ends at a time up to rounding */
static const double rounding = 1e-9;

static int is_past(double at, double time)
{
    return isfinite(at) ? time >= at - rounding*fabs(at) : at < 0.0;
}

int dem_walls_come_and_go(struct dem_walls *w, double time)
{
    int changed = 0;

    for (int k = 0; k < w->walls && w->passing > 0; k++)
    {
        struct dem_wall *const wall = &w->wall[k];
        const int absent = !is_past(wall->there[0], time) || is_past(wall->there[1], time);

        changed |= absent != wall->absent;
        wall->came = wall->absent && !absent;
        wall->absent = absent;
    }
    return changed;
}

double dem_walls_next_change(const struct dem_walls *w, double time)
{
    double next = INFINITY;

    for (int k = 0; k < w->walls && w->passing > 0; k++)
    {
        for (int side = 0; side < 2; side++)
        {
            const double at = w->wall[k].there[side];

            next = is_past(at, time) ? next : fmin(next, at);
        }
    }
    return next;
}
