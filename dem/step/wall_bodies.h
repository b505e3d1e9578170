/*
 * wall_bodies.h -- walls that are moved by force, in the step: sums over their contacts, kicks, drifts.
 *
 * All ranks have the same sums, as these are exact, and so move a wall alike. A scene without such
 * walls calls none of these functions (dem_walls.bodies is 0).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "contacts/contact_batch.h"
#include "ranks/dem_state.h"

/* K dt^2/m, so that the period of a wall on its contacts is at least 31 steps. */
#define DEM_WALL_BODY_MAX_SWING 0.04

/* With the drift of the particles, before walls move. */
void dem_wall_bodies_drift(struct dem_state *);

/* In a sweep: before it; after the effects have acted on the rows of a batch. */
void dem_wall_bodies_begin_sweep(struct dem_walls *);
void dem_wall_bodies_add_batch(struct dem_state *, const struct dem_contact_batch *,
                               const struct dem_effect_list *, uint32_t row, int rows);

/* Collective, after it: one reduction for each wall. An error when contacts are too stiff for the mass of a wall, or a
   servo finds no particle. */
int dem_wall_bodies_sum(struct dem_state *);

/* The forces of the last sweep act for `kick` [s]. */
void dem_wall_bodies_kick(struct dem_state *, double kick);

/* Copy the state for the backup; kick the copy; put it back. */
void dem_wall_bodies_backup(struct dem_walls *);
void dem_wall_bodies_kick_backup(struct dem_state *, double kick);
void dem_wall_bodies_restore(struct dem_walls *);
