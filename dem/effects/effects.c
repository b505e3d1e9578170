/*
 * effects.c -- the list of all effects and the search in it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effects.h"

#include "base/unknown.h"

#include <string.h>

#define DEM_EFFECT_POINTER(name) &dem_##name,
const struct dem_effect *const dem_effects[] = {DEM_EFFECT_ROWS(DEM_EFFECT_POINTER) NULL};
#undef DEM_EFFECT_POINTER

enum
{
    EFFECTS = (int)(sizeof dem_effects/sizeof dem_effects[0]) - 1
};

const struct dem_effect *dem_effects_find(const char *name)
{
    for (int k = 0; k < EFFECTS; k++)
    {
        if (strcmp(dem_effects[k]->name, name) == 0)
        {
            return dem_effects[k];
        }
    }
    return NULL;
}

int dem_effects_unknown(const char *where, const char *name)
{
    const char *known[EFFECTS];

    for (int k = 0; k < EFFECTS; k++)
    {
        known[k] = dem_effects[k]->name;
    }
    return dem_error_prefix(dem_unknown_word("effect", name, known, EFFECTS), "%s: ", where);
}
