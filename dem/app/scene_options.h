/*
 * scene_options.h -- common to the commands that take a scene: command-line options, set-up of the
 * scene, its schedule.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_APP_SCENE_OPTIONS_H
#define DEM_APP_SCENE_OPTIONS_H

#include "dem.h"
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
    DEM_MAX_SETS = 64,  /* -set options on a command line */
    DEM_MAX_OPTIONS = 16
};

/* an option of one command */
struct dem_option
{
    const char *name, *alias;  /* "-window"; another name that is accepted, or NULL */
    int flag;                  /* 1: it takes no value */
    const char *given;         /* its value, "" for a flag; NULL when it is not given */
};

/* a command line */
struct dem_request
{
    const char *scene, *restart;
    const char *set[2*DEM_MAX_SETS][2];  /* path and value; half is for what a command sets
                                            itself */
    int sets, help;
    const char *without;                 /* an effect that is left out of the scene; NULL: none */
    int no_output;                       /* 1: no output files, no energy balance */
    struct dem_option *option;
    int options;
};

struct dem_command
{
    const char *name, *help;
    int (*run)(struct dem_program *, struct dem *, const struct dem_schedule *);
};

/* Read the arguments [-restart SNAPSHOT] [-set PATH VALUE | -set PATH=VALUE] ... SCENE, and the
   command's own options. Strings point into argv, where the `=` becomes the end of the path. */
int dem_request_read(struct dem_request *, const char *command, int argc, char **argv);

/* Collective. Read, check and set up the scene of a command line. The caller frees the
   simulation; NULL after an error. */
int dem_scene_open(const struct dem_program *, const struct dem_request *, struct dem **,
                   struct dem_schedule *);

/* Collective. Run a command: read the arguments, print its help or set up the scene, call
   `run`, free. */
int dem_command_run(struct dem_program *, const struct dem_command *, int argc, char **argv);

#endif
