/*
 * plan.h -- `dem plan -write`: put the plan's choice of effects into the scene.
 *
 *   plan.c         the command `dem plan`
 *   plan_write.c   -write: dem_scene_rewrite with the scene of the command line
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_APP_COMMAND_PLAN_H
#define DEM_APP_COMMAND_PLAN_H

#include "app/scene_options.h"

/* On one rank only. Rewrite the scene of the command line, keep the old text as SCENE.before,
   and print what was changed. */
int dem_plan_rewrite(struct dem_program *, const struct dem_request *);

#endif
