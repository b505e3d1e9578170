/*
 * fill_batch.h -- fill a contact batch: gather the partners of contact rows, compute geometry and
 * relative motion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "contacts/contact_batch.h"
#include "ranks/dem_state.h"

/* Gather the partners of `rows` contact rows of one pair class from `row` on, compute geometry and
   relative motion. Lanes past the last row repeat it. */
void dem_contact_batch_fill(struct dem_contact_workspace *, const struct dem_state *,
                            const struct dem_effect_list *, uint32_t row, int rows);

static inline int dem_contact_batch_lanes(int rows)
{
    return (rows + DEM_LANES - 1)/DEM_LANES*DEM_LANES;
}

/* The same for `rows` pairs of particles of a class without effects past touching. `partners`: of all lanes,
   those past the last row repeat it, and DEM_ROWS_AHEAD more. */
void dem_contact_batch_fill_pairs(struct dem_contact_workspace *, const struct dem_state *,
                                  const struct dem_effect_list *,
                                  const struct dem_row_partners *partners, int rows);
