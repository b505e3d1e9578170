/*
 * parcel_forces.h -- evaluate fluid effects on the grains of parcels (laws/parcels.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/interaction_table.h"
#include "step/body_scalars.h"

/* prepare_bodies of an effect on grains; ratio: of the rows of the batch. */
void dem_parcels_prepare(const struct dem_effect_entry *, struct dem_body_batch *,
                         const double ratio[DEM_BATCH_ROWS]);

/* apply_to_bodies of an effect on grains, times the number of grains. Its scalars are selected
   (dem_body_scalars_select). */
void dem_parcels_apply(const struct dem_effect_entry *, struct dem_body_batch *,
                       const double ratio[DEM_BATCH_ROWS]);
