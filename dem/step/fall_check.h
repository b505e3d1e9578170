/*
 * fall_check.h -- a bed that falls through its walls ends the run.
 *
 * Where time/maxOverlap is above 0.5, single passages are only reported (records/lost_particles.h);
 * more than 10 that are also more than 1 % of the particles are an error. Otherwise each passage is
 * an error, and so is one through a wall at which no normal law acts (records/lost_cause.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"

/* Collective. DEM_OK, or DEM_ERROR_LOST. */
int dem_fall_check(const struct dem_state *);
