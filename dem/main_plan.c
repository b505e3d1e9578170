/*
 * main_plan.c -- `dem plan SCENE`: everything is read and checked as by `dem run`, and told; nothing is written.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main_scene.h"
#include "base/error.h"
#include <math.h>
#include <stdio.h>

static const char help[] =
    "Usage: dem plan [-restart SNAPSHOT] [-set PATH VALUE] ... SCENE\n"
    "       mpirun -np N dem plan SCENE\n\n"
    "Reads and checks a scene like dem run, and tells what would run: effects and their settings, contacts, walls,\n"
    "particles, the bed's weight, fluidisation, the time step and what bounds it, memory and time.\n"
    "Nothing is simulated or written. For a coupled case: demPimpleFoam -plan.\n";

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

int dem_main_plan(struct dem_program *prog, int argc, char **argv)
{
    const struct dem_command command = {.name = "plan", .help = help, .serve = tell};

    return dem_scene_serve(prog, &command, argc, argv);
}
