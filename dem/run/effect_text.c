/*
 * effect_text.c -- an effect as text: stage, summary, source, limitation and settings.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/effect_text.h"
#include <math.h>

static const char *const stages[DEM_STAGES] = {"normal", "damping", "tangential", "moment",
                                               "bond", "film", "scalar", "body", "fluid"};

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
    else if (f->kind == DEM_SETTING_CHOICE)
    {
        dem_text_add(t, "default %s", f->choices[(int)f->default_value]);
    }
    else
    {
        dem_text_add(t, "default %g", f->default_value);
    }
}

static void add_range(struct dem_text *t, const struct dem_setting *f)
{
    if (f->kind == DEM_SETTING_NUMBER || f->kind == DEM_SETTING_VECTOR)
    {
        dem_text_add(t, ", %s%g .. %g", f->min == DEM_ABOVE_ZERO ? "above " : "",
               f->min == DEM_ABOVE_ZERO ? 0.0 : f->min, f->max);
    }
    for (int k = 0; f->kind == DEM_SETTING_CHOICE && f->choices[k]; k++)
    {
        dem_text_add(t, "%s%s", k ? " | " : ": ", f->choices[k]);
    }
}

void dem_effect_text_add(struct dem_text *t, const struct dem_effect *e)
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
        add_default(t, f);
        add_range(t, f);
        dem_text_add(t, "\n%-30s %s\n", "", f->help);
    }
    dem_text_add(t, "\n");
}
