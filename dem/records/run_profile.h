/*
 * run_profile.h -- the cost of a run over all ranks: times, counts, communication, memory.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_RECORDS_RUN_PROFILE_H
#define DEM_RECORDS_RUN_PROFILE_H

#include "dem_types.h"
#include "ranks/dem_state.h"

/* Collective. The profile since dem_timers_begin. Does not change the state. */
void dem_profile_take(struct dem_state *, struct dem_profile *);

#endif
