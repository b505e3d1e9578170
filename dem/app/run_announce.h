/*
 * run_announce.h -- what `dem run` prints before the first step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "app/scene_options.h"

/* Collective. */
int dem_run_announce(const struct dem_program *, struct dem *, const struct dem_schedule *);

/* What makes the steps, where the scene asks for a device. */
void dem_run_announce_device(const struct dem_program *, const struct dem *);
