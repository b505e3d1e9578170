/*
 * device_columns.h -- columns of particles on the device: a fluid's, orientations, scalars.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/text.h"
#include "device/opencl_device.h"
#include "particles/particles.h"

/* Text for kernels: #define COLUMN_<NAME> for each column that these particles have, COLUMN_FURTHER_<k> for scalars.
   The values are numbers per particle before it. Returns 1 when there is a fluid. */
int dem_device_columns_text(const struct dem_particles *, struct dem_text *);

/* Numbers per particle of all of them. */
size_t dem_device_columns_width(const struct dem_particles *);

/* All columns to the device; the ones that change, back. */
int dem_device_put_columns(struct dem_opencl *, const struct dem_opencl_memory *,
                           const struct dem_particles *);
int dem_device_get_columns(struct dem_opencl *, const struct dem_opencl_memory *,
                           const struct dem_particles *);
