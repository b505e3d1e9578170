/*
 * effects_api.c -- the list of effects as text: their settings.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/internal.h"
#include "run/effect_text.h"
#include "core/error.h"
#include "laws/effects.h"

const char *dem_effect_name(int k)
{
    const struct dem_effect *const *e = dem_effects;

    while (*e && k > 0)
    {
        e++;
        k--;
    }
    return k >= 0 && *e ? (*e)->name : NULL;
}

int dem_effect_text(struct dem *d, const char *effect, const char **text)
{
    const struct dem_effect *const e = effect ? dem_effects_find(effect) : NULL;

    DEM_TRY(effect && !e ? dem_effects_unknown("effects", effect) : DEM_OK);
    dem_text_free(&d->effect);
    for (const struct dem_effect *const *other = dem_effects; *other; other++)
    {
        if (!e || e == *other)
        {
            dem_effect_text_add(&d->effect, *other);
        }
    }
    *text = d->effect.text;
    return d->effect.status;
}
