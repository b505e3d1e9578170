/*
 * run_loop.h -- the loop of `dem run`, from output to output.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "app/main.h"
#include "app/scene_options.h"

/* Advance to the end of the schedule, or until the particles rest, the stages are over or a signal
   stops the run (*stopped: 1); write all output and print the summary at the end. */
int dem_run_loop(const struct dem_program *prog, struct dem *d, const struct dem_schedule *s, int *stopped);
