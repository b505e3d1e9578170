/*
 * energy_row.h -- the energy of one law at one contact, in registers, for the energy balance.
 *
 * dem_<law>_energy_row(settings, row, before, after, energy) of a law with dem_effect.energy sets
 * `stored` and `lost`; before, after: its history before and after its row function. energy_loop.h
 * makes a loop over a batch of it; a device compiles it as OpenCL C. The columns are struct
 * dem_energy's (batch.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/row.h"

#define DEM_ENERGY_COLUMNS(COLUMN)                                                             \
    COLUMN(previous_overlap) COLUMN(previous_kn) COLUMN(normal_force)                          \
    COLUMN(mx) COLUMN(my) COLUMN(mz) COLUMN(inertia) COLUMN(slip_mass)                         \
    COLUMN(stored) COLUMN(lost)

struct dem_energy_row
{
    DEM_ENERGY_COLUMNS(DEM_ROW_MEMBER)
};
