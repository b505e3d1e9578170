/*
 * self_test.h -- whether a device computes the laws of a program with the bits of the CPU.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "device/opencl_device.h"
#include "laws/interaction_table.h"

/* Random rows of each pair class through the laws of the class, on the device and here.
   DEM_ERROR_STATE with the numbers when a bit differs. */
int dem_device_self_test(struct dem_opencl *, const struct dem_interaction_table *);
