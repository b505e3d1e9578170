/*
 * main_effects.c -- `dem effects`: the manual's table, straight from the effects' own descriptions; -cost is in main_effects_cost.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main_effects.h"
#include "base/error.h"
#include "effects/effects.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const stages[DEM_STAGES] = {"normal", "damping", "tangential", "moment", "bond", "film", "body", "fluid"};

static void print_default(const struct dem_field *f)
{
    if (f->kind == DEM_FIELD_SWITCH)
    {
        printf("default %s", f->def > 0.0 ? "yes" : "no");
    }
    else if (isnan(f->def))
    {
        printf("required");
    }
    else if (f->kind == DEM_FIELD_CHOICE)
    {
        printf("default %s", f->choices[(int)f->def]);
    }
    else
    {
        printf("default %g", f->def);
    }
}

static void print_range(const struct dem_field *f)
{
    if (f->kind == DEM_FIELD_NUMBER || f->kind == DEM_FIELD_VECTOR)
    {
        printf(", %s%g .. %g", f->least == DEM_ABOVE_ZERO ? "above " : "", f->least == DEM_ABOVE_ZERO ? 0.0 : f->least, f->most);
    }
    for (int k = 0; f->kind == DEM_FIELD_CHOICE && f->choices[k]; k++)
    {
        printf("%s%s", k ? " | " : ": ", f->choices[k]);
    }
}

static void print_effect(const struct dem_effect *e)
{
    printf("%-18s %-11s %s\n%-30s source: %s\n", e->name, stages[e->stage], e->says, "", e->source);
    for (const struct dem_field *f = e->settings; f && f->name; f++)
    {
        printf("    %-22s [%s] ", f->name, f->kind == DEM_FIELD_SWITCH ? "switch" : f->kind == DEM_FIELD_CHOICE ? "choice" : f->unit);
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
        printf("Usage: dem effects [WORD ...]\n       dem effects -cost [WORD ...]\n\nAll effects, or those named: word, stage, what it does, source; "
               "then each setting with unit,\ndefault, range and meaning. Use the words in the scene's effects { ... }.\n\n"
               "    -cost   instead what each takes, measured now: nanoseconds a particle and a contact, share of the step, bytes\n");
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
