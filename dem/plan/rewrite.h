/*
 * rewrite.h -- the plan's choice of effects goes into the text of a scene (dem_rewrite in dem.h).
 *
 *   rewrite.c   verdicts into edits, one after the other, each tried
 *   edit.c      what an edit does to the text: an effect is added, renamed or commented out; nothing else is touched
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_PLAN_REWRITE_H
#define DEM_PLAN_REWRITE_H

#include "plan/text.h"

/* Into *to, from the text of a scene; `why` becomes a comment. The number of places that were changed: 0 when the effect does not stand in
   the text itself (an #include or a macro brings it). To be freed. */
int dem_edit_add(struct dem_text *to, const char *text, const char *effect, const char *why);
int dem_edit_rename(struct dem_text *to, const char *text, const char *effect, const char *other, const char *why);
int dem_edit_leave_out(struct dem_text *to, const char *text, const char *effect, const char *why);

#endif
