/*
 * main_plan.h -- `dem plan`, and `dem plan -write`, which puts the plan's choice of effects into the scene.
 *
 *   main_plan.c         the command
 *   main_plan_write.c   verdicts into edits, one after the other, each tried
 *   main_plan_edit.c    what an edit does to the text: an effect is added, renamed or commented out; nothing else is touched
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MAIN_PLAN_H
#define DEM_MAIN_PLAN_H

#include "main_scene.h"
#include "plan/text.h"

/* Collective; of one rank only. Writes the scene of the request anew, its text of before beside it, and tells what was changed. */
int dem_plan_rewrite(struct dem_program *, const struct dem_request *);

/* Into *to, from the text of a scene; `why` becomes a comment. The number of places that were changed: 0 when the effect does not stand in
   the text itself (an #include or a macro brings it). To be freed. */
int dem_edit_add(struct dem_text *to, const char *text, const char *effect, const char *why);
int dem_edit_rename(struct dem_text *to, const char *text, const char *effect, const char *other, const char *why);
int dem_edit_leave_out(struct dem_text *to, const char *text, const char *effect, const char *why);

#endif
