/*
 * stages_text.c -- the stages that have not begun, as text: what the stage before waits for, and what
 * waits for them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "case/stages.h"
#include "core/text.h"
#include "dem_query.h"
#include <math.h>

static void write_wait(struct dem_text *t, const struct dem_walls *w, const struct dem_run_stage *s)
{
    if (s->until == DEM_UNTIL_LOAD)
    {
        dem_text_add(t, "%s waits for %g N on wall %s", s->name, s->load, w->wall[s->wall_index].name);
    }
    else if (s->until == DEM_UNTIL_QUIET)
    {
        dem_text_add(t, "%s waits until the particles rest", s->name);
    }
    else
    {
        dem_text_add(t, "%s lasts %g s", s->name, s->duration);
    }
}

static void list(struct dem_text *t, int *n, const char *what, const char *name)
{
    dem_text_add(t, "%s %s %s", (*n)++ ? "," : "; for it waited", what, name);
}

/* Whether a motion of the wall names the stage. */
static int moves(const struct dem_walls *w, int wall, int number)
{
    const int frame = w->wall[wall].frame;
    const struct dem_wall_frame *const f = frame >= 0 ? &w->frame[frame] : NULL;
    const struct dem_compound_motion *const c = f ? f->compound : NULL;
    int found = 0;

    for (int side = 0; side < 2 && f; side++)
    {
        found |= f->motion.stage[side] == number;
        found |= c && c->body && c->body->stage[side] == number;
        for (int k = 0; c && k < c->parts; k++)
        {
            found |= c->part[k].motion.stage[side] == number;
        }
    }
    return found;
}

static void write_waiting(struct dem_text *t, const struct dem *d, int number)
{
    static const char *const axis[] = {"xx", "yy", "zz", "xy"};
    const struct dem_walls *const w = &d->state.walls;
    const struct dem_streams *const streams = &d->scene.streams;
    int n = 0;

    for (int k = 0; k < streams->streams; k++)
    {
        const struct dem_stream *const s = &streams->stream[k];

        if (s->stage[0] == number || s->stage[1] == number)
        {
            list(t, &n, s->at_once ? "group" : "stream", s->name);
        }
    }
    for (int k = 0; k < w->walls; k++)
    {
        if (w->wall[k].there_stage[0] == number || w->wall[k].there_stage[1] == number)
        {
            list(t, &n, "wall", w->wall[k].name);
        }
        if (moves(w, k, number))
        {
            list(t, &n, "the motion of wall", w->wall[k].name);
        }
    }
    for (int k = 0; k < 4; k++)
    {
        const struct dem_cell_axis *const a = k < 3 ? &d->state.cell.axis[k] : &d->state.cell.shear;

        if (a->stage[0] == number || a->stage[1] == number)
        {
            list(t, &n, "domain/cell", axis[k]);
        }
    }
}

int dem_stages_left_text(const struct dem *d, const char **text)
{
    static _Thread_local struct dem_text t;
    const struct dem_run_stages *const s = &d->scene.stages;

    dem_text_free(&t);
    dem_text_add(&t, "%s", "");
    for (int k = 1; k < s->n; k++)
    {
        if (!isfinite(s->stage[k].begin))
        {
            dem_text_add(&t, "stage %s never began: ", s->stage[k].name);
            write_wait(&t, &d->state.walls, &s->stage[k - 1]);
            write_waiting(&t, d, k + 1);
            dem_text_add(&t, "\n");
        }
    }
    *text = t.text;
    return t.status;
}
