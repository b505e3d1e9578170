/*
 * run_announce.c -- what `dem run` prints before the first step: particles, step, gravity, fluid
 * effects, walls, warnings.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/run_announce.h"
#include "app/progress.h"
#include "dem_plan.h"
#include "core/error.h"
#include <math.h>
#include <stdio.h>

/* Triangles that were left out of walls, which the user may not know of. */
static void announce_walls(const struct dem *d)
{
    for (int w = 0; w < dem_wall_count(d); w++)
    {
        struct dem_wall_info f;

        dem_wall_info(d, w, &f);
        if (f.flat + f.repeats > 0)
        {
            printf("wall %s: %lld triangles; left out %lld without area, %lld given before\n",
                   dem_wall_name(d, w), (long long)f.triangles, (long long)f.flat,
                   (long long)f.repeats);
        }
    }
}

static void announce_gravity(const struct dem_schedule *s)
{
    const double *const g = s->gravity;

    if (g[0] != 0.0 || g[1] != 0.0 || g[2] != 0.0)
    {
        printf("gravity (%g %g %g) m/s2\n", g[0], g[1], g[2]);
    }
    else
    {
        printf("no gravity: effects/gravity is %s\n", s->with_gravity ? "zero" : "not there");
    }
}

/* Steps end at each output and row. */
static void announce_short_interval(const struct dem_schedule *s, double step)
{
    const char *const entry[] = {"interval", "walls", "cell", "energy"};
    const double of[] = {s->interval < s->end ? s->interval : INFINITY, s->output.walls, s->output.cell, s->output.energy};
    int least = 0;

    for (int k = 1; k < 4; k++)
    {
        least = of[k] > 0.0 && of[k] < of[least] ? k : least;
    }
    if (of[least] < step*(1.0 - 1e-9))
    {
        printf("write/%s %g s is shorter than the step %.4g s: steps end at each row, so the run makes %.3g times as "
               "many\n", entry[least], of[least], step, step/of[least]);
    }
}

/* What is likely to be a mistake, as a list; nothing to run, nothing to warn of. */
static int warn(const struct dem_program *prog, struct dem *d, double duration)
{
    const struct dem_run_info ahead = {.duration = duration};
    const char *text;

    if (duration <= 0.0)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_warnings(d, &ahead, 0, NULL, &text));
    if (prog->rank == 0)
    {
        fputs(text, stdout);
        fflush(stdout);
    }
    return DEM_OK;
}

int dem_run_announce(const struct dem_program *prog, struct dem *d, const struct dem_schedule *s)
{
    const struct dem_step_limit step = dem_step_limit(d);
    struct dem_totals t;
    char particles[80];

    DEM_TRY(dem_totals(d, &t));
    if (prog->rank == 0)
    {
        printf("Suna: %s, %d walls, %d rank%s\nstep %.4g s, limit %.4g s: %s\n",
               dem_progress_particles(&t, particles), dem_wall_count(d), prog->ranks, prog->ranks > 1 ? "s" : "",
               step.used, step.limit, step.why);
        announce_short_interval(s, step.used);
        announce_gravity(s);
        if (dem_fluid_effect_names(d)[0])
        {
            printf("fluid effects: %s\n", dem_fluid_effect_names(d));
        }
        if (s->coupling)
        {
            printf("coupling is not read: that entry is for coupled runs in OpenFOAM\n");
        }
        announce_walls(d);
        if (t.time >= s->end*(1.0 - 1e-12))
        {
            printf("nothing to run: time continues from the snapshot, and its %.6g s are "
                   "time/end\n",
                   t.time);
        }
        fflush(stdout);
    }
    return warn(prog, d, fmax(0.0, s->end - t.time));
}

void dem_run_announce_device(const struct dem_program *prog, const struct dem *d)
{
    if (prog->rank == 0 && dem_device(d)[0])
    {
        printf("device: %s\n", dem_device(d));
        fflush(stdout);
    }
}
