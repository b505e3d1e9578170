/*
 * contact_scalars.h -- particle scalars of a contact batch: values of both partners, rates that
 * effects add to, rates of walls (laws/scalar.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "contacts/contact_batch.h"
#include "ranks/dem_state.h"

struct dem_contact_scalars
{
    struct dem_scalar_rows rows[DEM_EFFECT_SCALARS];    /* of the present effect */
    _Alignas(64) double value[2][DEM_SCALARS][DEM_BATCH_ROWS];
    _Alignas(64) double rate[2][DEM_SCALARS][DEM_BATCH_ROWS];
    _Alignas(64) double radius[2][DEM_BATCH_ROWS];    /* with DEM_NEEDS_RADII */
};

/* Gather the values of the partners of `rows` rows, from `row` on, of a batch that has been filled.
   Rates are the walls' rates, or 0. */
void dem_contact_scalars_gather(struct dem_contact_scalars *, const struct dem_state *,
                                const struct dem_contact_batch *, uint32_t row, int rows);

/* Before an effect acts: let `scalars` of the batch be the scalars of its list. */
void dem_contact_scalars_select(struct dem_contact_workspace *, const struct dem_effect_entry *);

/* Store the rates of all rows, for the sum by particle. */
void dem_contact_scalars_store(const struct dem_contact_scalars *, struct dem_contacts *,
                               uint32_t row, int rows);
