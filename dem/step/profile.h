/*
 * profile.h -- what a run has cost, over all ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_PROFILE_H
#define DEM_STEP_PROFILE_H

#include "dem.h"
#include "step/parts.h"

/* Collective. Since dem_phases_begin. Changes nothing of the state. */
void dem_profile_take(struct dem_parts *, struct dem_profile *);

#endif
