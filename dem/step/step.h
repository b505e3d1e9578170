/*
 * step.h -- one step of the particles, and the windows that steps are grouped in.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_STEP_H
#define DEM_STEP_STEP_H

#include "step/parts.h"

/* Collective. Advance `steps` steps of dt [s] in one window: a half kick at its start and its end, full kicks between,
   so that positions and velocities are synchronous before and after. When parts.asked says so on any rank, all stop after the
   step in which they hear of it: the window stays open, as it is, and dem_step_on goes on in it with the same bits. Another
   window after that takes velocities as they are, half a step ahead. */
int dem_step_window(struct dem_parts *, double dt, int64_t steps);
int dem_step_on(struct dem_parts *);

/* Collective. Copy the present state into parts.kept, unless it holds a number that is none; then the copy of before
   stays. In an open window, whose velocities are ahead, the first step makes the copy if there is none. */
int dem_step_keep(struct dem_parts *);

/* Collective. Order, copies, pairs, rows and memory anew, at the present positions. */
int dem_step_renew(struct dem_parts *);

#endif
