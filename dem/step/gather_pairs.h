/*
 * gather_pairs.h -- the partners of the pairs of a block, gathered into the columns of a tray.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_GATHER_PAIRS_H
#define DEM_STEP_GATHER_PAIRS_H

#include "step/tray.h"

/* Fill t->g and what the block has of single partners, for all lanes of the block. `near`: the row of the first lane, the others
   follow; `needs`: of the chain (enum dem_needs). */
void dem_gather_pairs(struct dem_tray *, const struct dem_parts *, unsigned needs, const struct dem_near *near);

#endif
