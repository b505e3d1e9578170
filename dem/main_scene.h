/*
 * main_scene.h -- what the commands that take a scene share: options, the scene made ready, its schedule.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MAIN_SCENE_H
#define DEM_MAIN_SCENE_H

#include "dem.h"
#include "main.h"
#include "main_output.h"
#include "main_quiet.h"

struct dem_schedule                                       /* time { ... } and write { ... } */
{
    double end, interval;                                 /* s */
    struct dem_quiet quiet;
    struct dem_output output;
    int with_gravity;                                     /* 1: among the effects */
    double gravity[3];                                    /* m/s2 */
    int coupling;                                         /* 1: the scene has an entry of that name, which is not read here */
};

enum
{
    DEM_MOST_SETS = 64,                                   /* that a user may give */
    DEM_MOST_OPTIONS = 16
};

struct dem_option                                         /* of one command alone */
{
    const char *name;                                     /* "-window" */
    int flag;                                             /* 1: it takes no value */
    const char *given;                                    /* its value, "" of a flag; NULL when it was not there */
};

struct dem_request                                        /* a command line */
{
    const char *scene, *restart;
    const char *set[2*DEM_MOST_SETS][2];                  /* room for what a command sets besides */
    int sets, help;
    const char *without;                                  /* an effect that is left out of the scene; NULL: none */
    int bare;                                             /* 1: nothing will be written, and no ledger kept */
    struct dem_option *option;
    int options;
};

struct dem_command
{
    const char *name, *help;
    int (*serve)(struct dem_program *, struct dem *, const struct dem_schedule *);
};

/* Read the arguments [-restart SNAPSHOT] [-set PATH VALUE] ... SCENE, and the command's own options. */
int dem_request_read(struct dem_request *, const char *command, int argc, char **argv);

/* Make the scene ready, check all of it. What it makes belongs to the caller; there is none after an error. */
int dem_scene_open(const struct dem_program *, const struct dem_request *, struct dem **, struct dem_schedule *);

/* All of this, and serve. */
int dem_scene_serve(struct dem_program *, const struct dem_command *, int argc, char **argv);

#endif
