/*
 * main_plan.c -- `dem plan SCENE`: everything is read and checked as by `dem run`, and told; nothing is written, but for what -write asks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main_plan.h"
#include "base/error.h"
#include <math.h>
#include <stdio.h>

static const char help[] =
    "Usage: dem plan [-restart SNAPSHOT] [-set PATH VALUE] ... SCENE\n"
    "       mpirun -np N dem plan SCENE\n"
    "       dem plan -write [-restart SNAPSHOT] SCENE\n\n"
    "Reads and checks a scene like dem run, and tells what would run: effects and their settings, contacts, walls,\n"
    "particles, the bed's weight, fluidisation, which effects the scene needs, the time step and what bounds it, memory and time.\n"
    "Nothing is simulated or written. For a coupled case: demPimpleFoam -plan, or -plan -write.\n\n"
    "    -write   puts the effects that the scene calls for into it, comments out those that are negligible, each with its reason,\n"
    "             and keeps the text of before as SCENE.before; what must be given a number that nobody can guess is told instead\n";

static int tell(struct dem_program *prog, struct dem *d, const struct dem_schedule *s)
{
    struct dem_tally t;
    const char *text;

    DEM_TRY(dem_tally(d, &t));
    const struct dem_prospect ahead = {.duration = fmax(0.0, s->end - t.time)};

    DEM_TRY(dem_plan(d, &ahead, &text));
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
    const int status = tell(prog, d, &s);

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
