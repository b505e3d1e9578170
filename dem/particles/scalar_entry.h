/*
 * scalar_entry.h -- values of particle scalars in the entries of a scene.
 *
 *     temperature 300;                         of all particles of a group, stream or snapshot
 *     temperature { min 290; max 310; }        uniform at random
 *
 * The word is the name of the scalar (laws/scalar.h). Walls: wall_scalars.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "input/dictionary.h"
#include "laws/interaction_table.h"

struct dem_scalar_entry
{
    int given;
    double min, max;    /* equal: one value */
};

/* Read the values of all scalars of the table, in its order. Those that are not given get the default
   of their row, or NaN with given = 0 where it has none: `required` refuses that. */
int dem_scalar_entries_read(const struct dem_dict *, const struct dem_interaction_table *,
                            int required, struct dem_scalar_entry entry[DEM_SCALARS]);

/* DEM_ERROR_INPUT, which begins with `where`, for a value out of the limits of a scalar. */
int dem_scalar_require(const struct dem_interaction_table *, int scalar, double value,
                       const char *where);

/* The ratio of the parcels of a group or stream, by which its diameters (of grains) are
   multiplied; 1 in a scene without parcels. */
int dem_scalar_entries_parcel_ratio(const struct dem_interaction_table *,
                                    const struct dem_scalar_entry entry[DEM_SCALARS],
                                    const char *where, double *ratio);

/* Refuse the name of a scalar that no effect of the scene has, with those that have it. `last`: the
   last stage that counts. */
int dem_scalar_refuse_unused(const struct dem_dict *, const struct dem_interaction_table *,
                             enum dem_stage last);
