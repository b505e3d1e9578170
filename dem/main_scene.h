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

struct dem_command
{
    const char *name, *help;
    int (*serve)(struct dem_program *, struct dem *, const struct dem_schedule *);
};

/* Read the arguments [-restart SNAPSHOT] [-set PATH VALUE] ... SCENE, make the scene ready, check all of it, serve. */
int dem_scene_serve(struct dem_program *, const struct dem_command *, int argc, char **argv);

#endif
