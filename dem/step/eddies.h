/*
 * eddies.h -- the turbulent eddies that particles are in.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/interaction_table.h"
#include "particles/particles.h"

/* Time dt [s] passes; particles whose time in an eddy is over enter another one. Nothing without an
   effect that has eddies. `step`: number of the step, for the random numbers. */
void dem_eddies_advance(struct dem_particles *, const struct dem_effect_list *effects, double dt,
                        int64_t step);

/* Fluctuation of the fluid velocity at particle i [m/s]; 0 without eddies. */
void dem_eddies_velocity(const struct dem_particles *, size_t i, double u[3]);
