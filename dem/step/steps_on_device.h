/*
 * steps_on_device.h -- which steps of a window a device may make, and what the host keeps of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"

/* After phase 3 of step `first` of the window, whose positions and lists are valid: let the device
   make this step and the next ones, up to one that the host has to make. *made: how many; 0: the host
   makes this step. Otherwise time and steps of the state then belong to the last step made, and the
   particles have been drifted once more, for the next step. */
int dem_steps_on_device(struct dem_state *, int64_t first, int64_t *made);
