/*
 * effects.c -- `dem effects`: list the effects with their settings, from their descriptors; -cost
 * is in effects_cost.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/effects.h"
#include "core/error.h"
#include "effects/effects.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const stages[DEM_STAGES] = {"normal", "damping", "tangential", "moment",
                                               "bond", "film", "body", "fluid"};

static void print_default(const struct dem_setting *f)
{
    if (f->kind == DEM_SETTING_SWITCH)
    {
        printf("default %s", f->default_value > 0.0 ? "yes" : "no");
    }
    else if (isnan(f->default_value))
    {
        printf("required");
    }
    else if (f->kind == DEM_SETTING_CHOICE)
    {
        printf("default %s", f->choices[(int)f->default_value]);
    }
    else
    {
        printf("default %g", f->default_value);
    }
}

static void print_range(const struct dem_setting *f)
{
    if (f->kind == DEM_SETTING_NUMBER || f->kind == DEM_SETTING_VECTOR)
    {
        printf(", %s%g .. %g", f->min == DEM_ABOVE_ZERO ? "above " : "",
               f->min == DEM_ABOVE_ZERO ? 0.0 : f->min, f->max);
    }
    for (int k = 0; f->kind == DEM_SETTING_CHOICE && f->choices[k]; k++)
    {
        printf("%s%s", k ? " | " : ": ", f->choices[k]);
    }
}

static void print_effect(const struct dem_effect *e)
{
    printf("%-18s %-11s %s\n%-30s source: %s\n", e->name, stages[e->stage], e->summary, "",
           e->source);
    if (e->limitation)
    {
        printf("%-30s limitation: %s\n", "", e->limitation);
    }
    for (const struct dem_setting *f = e->settings; f && f->name; f++)
    {
        printf("    %-22s [%s] ", f->name,
               f->kind == DEM_SETTING_SWITCH ? "switch"
               : f->kind == DEM_SETTING_CHOICE ? "choice"
                                               : f->unit);
        print_default(f);
        print_range(f);
        printf("\n%-30s %s\n", "", f->help);
    }
    printf("\n");
}

int dem_main_effects(struct dem_program *p, int argc, char **argv)
{
    if (p->rank != 0)
    {
        return DEM_OK;
    }
    if (argc > 0 && strcmp(argv[0], "-help") == 0)
    {
        printf("Usage: dem effects [NAME ...]\n"
               "       dem effects -cost [NAME ...]\n\n"
               "Lists all effects, or those named: name, stage, what it does, source; then each\n"
               "setting with unit, default, range and meaning. The names are those of the scene's\n"
               "effects { ... }.\n\n"
               "    -cost   the cost of each effect instead, measured now: nanoseconds per "
               "particle\n"
               "            and per contact, fraction of the step, bytes\n");
        return DEM_OK;
    }
    if (argc > 0 && strcmp(argv[0], "-cost") == 0)
    {
        return dem_effects_cost(argc - 1, argv + 1);
    }
    for (int k = 0; k < argc; k++)
    {
        if (!dem_effects_find(argv[k]))
        {
            return dem_effects_unknown("dem effects", argv[k]);
        }
        print_effect(dem_effects_find(argv[k]));
    }
    for (const struct dem_effect *const *e = dem_effects; argc == 0 && *e; e++)
    {
        print_effect(*e);
    }
    return DEM_OK;
}
