/*
 * watch.h -- overlaps too large and forces that are not a number: seen in the sweep, told with names, place and step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_WATCH_H
#define DEM_STEP_WATCH_H

#include "step/parts.h"
#include "step/tray.h"

/* Remember the worst row so far, and who it is: of the tray's overlaps, least radii and forces, `rows` rows from `row` on. */
void dem_watch_note(struct dem_parts *, const struct dem_tray *, uint32_t row, int rows);

/* DEM_ERROR_NUMBER with the culprits' names when the worst is past the limit. */
int dem_watch_judge(const struct dem_parts *);

#endif
