/*
 * run_cost.h -- memory of a run by counting bytes; processor time by running a sample block.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_numbers.h"
#include "ranks/dem_state.h"
#include "records/inventory.h"

/* Collective: each rank runs its own block; times are of the slowest rank. The simulation is
   not changed. dt [s]: time step. Returns DEM_OK or an error. */
int dem_run_cost_measure(const struct dem_state *, const struct dem_inventory *, double dt,
                         struct dem_run_cost *);
