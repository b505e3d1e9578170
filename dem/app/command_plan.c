/*
 * plan.c -- `dem plan SCENE`: read and check a scene as `dem run` does, and print the plan; only
 * -write changes a file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/command_plan.h"
#include "core/error.h"
#include <math.h>
#include <stdio.h>

static const char help[] =
    "Usage: dem plan [-restart SNAPSHOT] [-set PATH VALUE] ... SCENE\n"
    "       mpirun -np N dem plan SCENE\n"
    "       dem plan -write [-restart SNAPSHOT] SCENE\n\n"
    "Reads and checks a scene like dem run, and reports: effects and their settings, contacts,\n"
    "walls, particles, the bed's weight, fluidisation, which effects the scene needs, the time\n"
    "step and what limits it, memory and run time. Nothing is simulated or written.\n"
    "For a coupled case: demPimpleFoam -plan, or -plan -write.\n\n"
    "    -write   adds the effects that the scene needs to it and comments out those that are\n"
    "             negligible, each with its reason; keeps the old text as SCENE.before; an effect\n"
    "             with a setting that has to be measured is reported instead\n";

static int report(struct dem_program *prog, struct dem *d, const struct dem_schedule *s)
{
    struct dem_totals t;
    const char *text;

    DEM_TRY(dem_totals(d, &t));
    const struct dem_run_info ahead = {.duration = fmax(0.0, s->end - t.time)};

    DEM_TRY(dem_plan(d, &ahead, &text));
    if (prog->rank == 0)
    {
        fputs(text, stdout);
    }
    DEM_TRY(dem_warnings(d, &ahead, 0, NULL, &text));
    if (prog->rank == 0)
    {
        fputs(text, stdout);
    }
    return DEM_OK;
}

static int plan(struct dem_program *prog, const struct dem_request *r)
{
    struct dem_schedule s;
    struct dem *d;

    DEM_TRY(dem_scene_open(prog, r, &d, &s));
    const int status = report(prog, d, &s);

    dem_free(d);
    return status;
}

int dem_main_plan(struct dem_program *prog, int argc, char **argv)
{
    struct dem_option write = {.name = "-write", .flag = 1};
    struct dem_request r = {.option = &write, .options = 1};

    DEM_TRY(dem_request_read(&r, "plan", argc, argv));
    if (r.help)
    {
        if (prog->rank == 0)
        {
            fputs(help, stdout);
        }
        return DEM_OK;
    }
    return write.given ? dem_plan_rewrite(prog, &r) : plan(prog, &r);
}
