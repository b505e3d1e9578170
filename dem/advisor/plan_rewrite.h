/*
 * plan_rewrite.h -- edits of the text of a scene by which the verdicts of a plan are applied.
 *
 *   plan_rewrite.c    turns verdicts into edits and tries them in turn (dem_scene_rewrite in dem.h)
 *   scene_edit.c      the edits of the text: an effect is added, renamed or commented out
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_ADVISOR_PLAN_REWRITE_H
#define DEM_ADVISOR_PLAN_REWRITE_H

#include "core/text.h"

/* Each writes the edited text of a scene to *to; `why` becomes a comment. Returns the number of
   positions changed: 0 if the effect is not in the text itself (but in an #include or a macro). The
   caller frees *to with dem_text_free. */
int dem_edit_add(struct dem_text *to, const char *text, const char *effect, const char *why);
int dem_edit_rename(struct dem_text *to, const char *text, const char *effect, const char *other,
                    const char *why);
int dem_edit_comment_out(struct dem_text *to, const char *text, const char *effect,
                         const char *why);

#endif
