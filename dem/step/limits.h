/*
 * limits.h -- limits check: overlaps and displacements above the limit and forces that are not a
 * number, reported with partners, position and step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"
#include "contacts/contact_batch.h"

/* Record the worst row so far and its partners, from overlaps, smaller radii and forces of a batch:
   `pair`, the pairs of its `rows` rows. */
void dem_limits_check_record(struct dem_state *, const struct dem_contact_workspace *,
                             const uint32_t *pair, int rows);

/* DEM_ERROR_NUMBER, with the names of the partners, when the worst row is above the limit. */
int dem_limits_check_status(const struct dem_state *);

/* After a drift, with the largest speed of this rank [m/s]: DEM_ERROR_NUMBER when a particle or a
   wall has moved too far. A particle that moves by more than its radius in one step may pass
   another, or triangles, unseen, and so may triangles that move towards it; the limit is the
   smallest radius of the materials with contact effects. Speeds above time/maxSpeed and above the
   speed of light are errors, too, and clumps that turn too far. */
int dem_limits_check_displacements(const struct dem_state *, double max_speed);

/* Largest speed [m/s] with which no particle fails this check. */
double dem_limits_max_speed(const struct dem_state *);

/* Largest displacement of a wall in a step [m], likewise. */
double dem_limits_max_wall_displacement(const struct dem_state *);
