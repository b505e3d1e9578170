/*
 * main_plan.h -- `dem plan`, and `dem plan -write`, which puts the plan's choice of effects into the scene.
 *
 *   main_plan.c         the command
 *   main_plan_write.c   the scene of the command line handed to dem_rewrite
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MAIN_PLAN_H
#define DEM_MAIN_PLAN_H

#include "main_scene.h"

/* Of one rank only. Writes the scene of the request anew, its text of before beside it, and tells what was changed. */
int dem_plan_rewrite(struct dem_program *, const struct dem_request *);

#endif
