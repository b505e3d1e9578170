/*
 * limits.h -- limits check: overlaps above the limit and forces that are not a number, reported
 * with partners, position and step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_LIMITS_H
#define DEM_STEP_LIMITS_H

#include "ranks/dem_state.h"
#include "contacts/contact_batch.h"

/* Record the worst row so far and its partners, from overlaps, smaller radii and forces of a batch:
   `rows` rows from `row` on. */
void dem_limits_check_record(struct dem_state *, const struct dem_contact_workspace *, uint32_t row,
                             int rows);

/* DEM_ERROR_NUMBER, with the names of the partners, when the worst row is above the limit. */
int dem_limits_check_status(const struct dem_state *);

#endif
