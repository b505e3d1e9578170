/*
 * effects.c -- the list of all effects and the look-up by name.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effects.h"

#include "core/aliases.h"
#include "core/did_you_mean.h"
#include "laws/parcels.h"

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
        const char *const short_name = dem_effects[k]->short_name;

        if (strcmp(dem_effects[k]->name, name) == 0 || (short_name && strcmp(short_name, name) == 0))
        {
            return dem_effects[k];
        }
    }
    return NULL;
}

int dem_scalar_is_known(const char *name)
{
    int found = strcmp(name, dem_parcel_ratio.name) == 0;

    for (int k = 0; k < EFFECTS; k++)
    {
        for (const struct dem_scalar *const *s = dem_effects[k]->scalars; s && *s; s++)
        {
            found |= strcmp((*s)->name, name) == 0;
        }
    }
    return found;
}

int dem_effect_is_alias(const struct dem_effect *effect, const char *word)
{
    return effect->aliases && dem_alias_is_among(effect->aliases, word);
}

int dem_effects_unknown(const char *where, const char *name)
{
    const char *known[EFFECTS], *aliases[EFFECTS];

    for (int k = 0; k < EFFECTS; k++)
    {
        known[k] = dem_effects[k]->name;
        aliases[k] = dem_effects[k]->aliases;
    }
    return dem_error_prefix(dem_did_you_mean_alias_error("effect", name, known, aliases, EFFECTS),
                            "%s: ", where);
}
