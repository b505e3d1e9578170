/*
 * step.h -- one time step of the particles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"
#include "step/sweep_bodies.h"

/* Collective. Step k of the window, begun at `since` [s]; with a device, also those after it that it
   makes. *k: the last one made. *status: an error of this rank, which the next agreement tells to the
   others. */
int dem_step(struct dem_state *, double since, int64_t *k, int *status);

/* The options that all sweeps of bodies have: a kick of `kick` [s], scalars integrated over h [s]; 0:
   none, they are only read. */
struct dem_body_sweep dem_step_sweep(const struct dem_state *, double kick, double h);

/* Ask the program for its forces on the particles of this rank. */
int dem_step_ask_for_forces(struct dem_state *);
