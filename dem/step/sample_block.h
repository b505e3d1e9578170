/*
 * sample_block.h -- a block of spheres with the physics of the scene, to be timed.
 *
 * Spheres of the mean diameter and the most frequent material on a body-centred lattice that just
 * touches, in a periodic box, with the interaction table and the skins of the scene. Each has 8
 * neighbors in contact and 6 more within a usual outer skin, so 4 contacts and 7 pairs per sphere,
 * a little more than a settled bed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "step/attached_stores.h"
#include "ranks/dem_state.h"
#include "records/inventory.h"

struct dem_sample
{
    struct dem_state state;
    struct dem_attached_stores stores;
};

/* Builds the block with its neighbor lists: as many spheres as the scene has, at most the largest
   lattice of up to `max`. It borrows the interaction table of the scene and must be freed before the scene, also
   after an error. Returns DEM_OK or an error. */
int dem_sample_block_make(struct dem_sample *, const struct dem_state *scene,
                          const struct dem_inventory *, int64_t max);
void dem_sample_block_free(struct dem_sample *);
