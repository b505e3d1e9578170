/*
 * steps_on_device.h -- which steps of a window a device may make, and what the host keeps of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_STEPS_ON_DEVICE_H
#define DEM_STEP_STEPS_ON_DEVICE_H

#include "ranks/dem_state.h"

/* After phase 3 of step `first` of the window, whose positions and lists are valid: let the device
   make this step and those after it up to the next one that the host has to make. *made: how many;
   positions are those of the step after them then, and time and steps of the state are those of the
   last one made. 0: the host makes this step. */
int dem_steps_on_device(struct dem_state *, int64_t first, int64_t *made);

#endif
