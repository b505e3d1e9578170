/*
 * command_plan.c -- `dem plan SCENE`: read and check a scene as `dem run` does, and print the plan.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/scene_options.h"
#include "dem_plan.h"
#include "core/error.h"
#include <math.h>
#include <stdio.h>

static const char help[] =
    "Usage: dem plan [-restart SNAPSHOT] [-device NAME] [-set PATH VALUE] ... SCENE\n"
    "       mpirun -np N dem plan SCENE\n\n"
    "Reads and checks a scene like dem run, and reports: effects and their settings, contacts,\n"
    "walls, particles, the bed's weight, fluidisation, which effects the scene needs, the time\n"
    "step and what limits it, memory and run time. Nothing is simulated or written.\n"
    "For a coupled case: demPimpleFoam -plan.\n";

static int plan(struct dem_program *prog, struct dem *d, const struct dem_schedule *s)
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

int dem_main_plan(struct dem_program *prog, int argc, char **argv)
{
    static const struct dem_command command = {"plan", help, plan};

    return dem_command_run(prog, &command, argc, argv);
}
