/*
 * profile.h -- a run told after it ran: where its time went.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_PLAN_PROFILE_H
#define DEM_PLAN_PROFILE_H

#include "dem.h"
#include "plan/text.h"

/* Nothing, when no step was made. */
int dem_profile_write(struct dem_text *, const struct dem_profile *);

#endif
