/*
 * tray.h -- one block of near rows on its way through the sweep: what was gathered of the partners, and the tray of the effects.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_TRAY_H
#define DEM_STEP_TRAY_H

#include "step/gathered.h"
#include "step/parts.h"

struct dem_tray
{
    struct dem_block block;
    struct dem_gathered g;
};

/* Fill the tray with the geometry and the relative motion of `rows` rows of one class, from `row` on, and clear its results. Lanes
   past the last row repeat it. */
void dem_tray_fill(struct dem_tray *, const struct dem_parts *, const struct dem_chain *, uint32_t row, int rows);

/* Only gather, of rows of pairs, for who goes on alone: `g` and `n` are filled. */
void dem_tray_gather(struct dem_tray *, const struct dem_parts *, const struct dem_chain *, uint32_t row, int rows);

#endif
