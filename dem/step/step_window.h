/*
 * step_window.h -- coupling windows, which group time steps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"

/* Collective. Advance `steps` time steps of dt [s] in one coupling window: a half kick at its start
   and at its end, full kicks between, so that positions and velocities are synchronous before and
   after. When `stop_request` of the state is not 0 on any rank, all ranks stop after the step in
   which they learn it. The window stays open then, and dem_step_continue completes it with the same
   bits. Another window started instead takes the velocities as they are, half a step ahead. */
int dem_step_window(struct dem_state *, double dt, int64_t steps);
int dem_step_continue(struct dem_state *);
