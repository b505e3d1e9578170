/*
 * run_profile.h -- the cost of a run over all ranks: times, counts, communication, memory.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_types.h"
#include "ranks/dem_state.h"

/* Collective. The profile since dem_timers_begin. Does not change the state. */
void dem_profile_take(struct dem_state *, struct dem_profile *);
