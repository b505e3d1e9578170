/*
 * effects_api.c -- the list of effects as text: their settings.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/internal.h"
#include "dem_plan.h"
#include "run/effect_text.h"
#include "core/error.h"
#include "laws/effects.h"

int dem_effect_text(const char *effect, const char **text)
{
    static _Thread_local struct dem_text all;
    const struct dem_effect *const e = effect ? dem_effects_find(effect) : NULL;

    DEM_TRY(effect && !e ? dem_effects_unknown("effects", effect) : DEM_OK);
    dem_text_free(&all);
    for (const struct dem_effect *const *other = dem_effects; *other; other++)
    {
        if (!e || e == *other)
        {
            dem_effect_text_add(&all, *other);
        }
    }
    *text = all.text;
    return all.status;
}

unsigned dem_effect_traits(const char *name)
{
    const struct dem_effect *const effect = dem_effects_find(name);

    if (!effect)
    {
        return 0;
    }
    return (effect->has_pressure_gradient ? DEM_TRAIT_PRESSURE_GRADIENT : 0U) |
           (effect->needs & DEM_NEEDS_ACCELERATION ? DEM_TRAIT_FLUID_ACCELERATION : 0U) |
           (effect->needs & DEM_NEEDS_STRESS ? DEM_TRAIT_FLUID_STRESS : 0U) |
           (effect->needs & DEM_NEEDS_TURBULENCE ? DEM_TRAIT_TURBULENCE : 0U) |
           (effect->needs & DEM_NEEDS_FLUID ? DEM_TRAIT_FLUID : 0U) |
           (effect->needs & DEM_NEEDS_VISCOSITY ? DEM_TRAIT_VISCOSITY : 0U);
}
