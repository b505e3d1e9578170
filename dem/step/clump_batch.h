/*
 * clump_batch.h -- spheres of rigid bodies in a batch of particles in a fluid (particles/clump_flow.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/clump_flow.h"
#include "ranks/dem_state.h"
#include "step/sweep_bodies.h"

/* Before the effects: rows of a body get the radius, mass and volume of its volume-equivalent sphere; `forms`: and
   its form. Forces so far are set aside. */
void dem_clump_batch_begin(const struct dem_clump_flow *, struct dem_body_workspace *, size_t first, int rows,
                           int forms);

/* After the effects and the slip factor: take the shares of their results out of the batch, so that the
   kick of the batch leaves these rows as they are. `over_window` as in dem_body_batch_gather_fluid. */
void dem_clump_batch_take(const struct dem_clump_flow *, struct dem_body_workspace *,
                          const struct dem_particles *, size_t first, int rows, double over_window);

/* In each sweep: keep the contact forces of a batch for the kick of the bodies. */
void dem_clump_batch_contacts(const struct dem_clumps *, const struct dem_contact_sum *, size_t first, int rows);

/* Before the sweeps: list the spheres of the bodies (dem_clumps_index), room for their forces. */
int dem_index_clumps(struct dem_state *);

/* After the sweep over all particles, with its options: kick the bodies, with or without a fluid, and
   integrate their temperatures. Pass the particles of the state or of its backup. It kicks the lanes of
   state->clumps in both cases: after a backup, call dem_clumps_store for the backup, then dem_clumps_load for the
   state. Returns the number of temperatures that are out of their range. */
int dem_kick_clumps(struct dem_state *, struct dem_particles *, const struct dem_body_sweep *);
