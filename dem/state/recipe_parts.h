/*
 * recipe_parts.h -- what the two files of the recipe share: settings for one pair of materials only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STATE_RECIPE_PARTS_H
#define DEM_STATE_RECIPE_PARTS_H

#include "state/recipe.h"

struct dem_override
{
    const struct dem_effect *effect;
    int pair[2], count;
    char entry[48], word[48], where[160];                 /* word: empty where there are values */
    double values[3];
};

/* Into a copy of the effect's settings. */
int dem_override_enter(const struct dem_override *, void *settings);

#endif
