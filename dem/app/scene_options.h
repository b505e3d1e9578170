/*
 * scene_options.h -- common to the commands that take a scene: command-line options, set-up of the
 * scene, its schedule.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_query.h"
#include "app/accuracy.h"
#include "app/main.h"
#include "app/output_files.h"

/* time { ... } and write { ... } */
struct dem_schedule
{
    double end, interval;  /* s */
    struct dem_quiet quiet;
    struct dem_output output;
    int with_gravity;      /* 1: among the effects */
    double gravity[3];     /* m/s2 */
    struct dem_accuracy accuracy;
    const struct dem_request *request;
    int coupling;          /* 1: the scene has an entry `coupling`, which is not read */
};

enum
{
    DEM_MAX_SETS = 64  /* -set options on a command line */
};

/* a command line */
struct dem_request
{
    const char *scene, *restart, *device;
    const char *set[DEM_MAX_SETS][2];  /* path and value */
    int sets, help, lists_devices;     /* 1: -help; -device list */
};

struct dem_command
{
    const char *name, *help;
    int (*run)(struct dem_program *, struct dem *, const struct dem_schedule *);
};

/* Collective. Run a command: read the arguments [-restart SNAPSHOT] [-device NAME]
   [-set PATH VALUE | -set PATH=VALUE] ... SCENE, print its help or set up the scene, call `run`,
   free. Strings of the request point into argv, where the `=` becomes the end of the path. */
int dem_command_run(struct dem_program *, const struct dem_command *, int argc, char **argv);
