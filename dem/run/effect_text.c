/*
 * effect_text.c -- effects as text: stage, summary, source, limitation and settings; their traits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "dem_plan.h"
#include "case/simulation.h"
#include "core/error.h"
#include "laws/effects.h"
#include <math.h>

static const char *const stages[DEM_STAGES] = {"normal", "damping", "tangential", "moment",
                                               "bond", "film", "scalar", "body", "fluid"};

static void add_choices(struct dem_text *t, const struct dem_setting *f)
{
    for (int k = 0; f->choices[k]; k++)
    {
        dem_text_add(t, "%s%s%s", k ? " | " : "", f->choices[k], k == f->default_value ? " (default)" : "");
    }
}

static void add_default(struct dem_text *t, const struct dem_setting *f)
{
    if (f->kind == DEM_SETTING_SWITCH)
    {
        dem_text_add(t, "default %s", f->default_value > 0.0 ? "yes" : "no");
    }
    else if (isnan(f->default_value))
    {
        dem_text_add(t, "required");
    }
    else
    {
        dem_text_add(t, "default %g", f->default_value);
    }
}

static void add_range(struct dem_text *t, const struct dem_setting *f)
{
    const char *const above = f->min == DEM_ABOVE_ZERO ? "above " : "";
    const double min = f->min == DEM_ABOVE_ZERO ? 0.0 : f->min;

    if (f->kind != DEM_SETTING_NUMBER && f->kind != DEM_SETTING_VECTOR)
    {
        return;
    }
    if (isfinite(f->max))
    {
        dem_text_add(t, ", %s%g to %g", above, min, f->max);
    }
    else if (isfinite(min))
    {
        dem_text_add(t, ", %s %g", f->min == DEM_ABOVE_ZERO ? ">" : ">=", min);
    }
}

/* Name, stage, summary, source and limitation, a line or two of each setting, and an empty line. */
static void add_effect(struct dem_text *t, const struct dem_effect *e)
{
    dem_text_add(t, "%-18s %-11s %s\n%-30s source: %s\n", e->name, stages[e->stage], e->summary, "",
           e->source);
    if (e->limitation)
    {
        dem_text_add(t, "%-30s limitation: %s\n", "", e->limitation);
    }
    for (const struct dem_setting *f = e->settings; f && f->name; f++)
    {
        dem_text_add(t, "    %-22s [%s] ", f->name,
               f->kind == DEM_SETTING_SWITCH ? "switch"
               : f->kind == DEM_SETTING_CHOICE ? "choice"
                                               : f->unit);
        if (f->kind == DEM_SETTING_CHOICE)
        {
            add_choices(t, f);
        }
        else
        {
            add_default(t, f);
            add_range(t, f);
        }
        dem_text_add(t, "\n%-30s %s\n", "", f->help);
    }
    dem_text_add(t, "\n");
}

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
            add_effect(&all, *other);
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
           (effect->needs & DEM_NEEDS_INTERFACE ? DEM_TRAIT_INTERFACE : 0U) |
           (effect->needs & DEM_NEEDS_FLUID ? DEM_TRAIT_FLUID : 0U) |
           (effect->needs & DEM_NEEDS_VISCOSITY ? DEM_TRAIT_VISCOSITY : 0U);
}
