/*
 * command_effects.c -- `dem effects`: list the effects with their settings.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/main.h"
#include "core/error.h"
#include "dem_plan.h"
#include <stdio.h>
#include <string.h>

static const char help[] =
    "Usage: dem effects [NAME ...]\n\n"
    "Lists all effects, or those named: name, stage, what it does, source; then each\n"
    "setting with unit, default, range and meaning. The names are the words of\n"
    "effects { ... } in a scene.\n";

/* Print the text of one effect, or of all (NULL). */
static int print_effect(const char *effect)
{
    const char *text;

    DEM_TRY(dem_effect_text(effect, &text));
    fputs(text, stdout);
    return DEM_OK;
}

static int print_effects(int names, char **name)
{
    const char *known;

    for (int k = 0; k < names; k++)    /* all of them are known before one is printed */
    {
        DEM_TRY(dem_effect_text(name[k], &known));
    }
    DEM_TRY(names == 0 ? print_effect(NULL) : DEM_OK);
    for (int k = 0; k < names; k++)
    {
        DEM_TRY(print_effect(name[k]));
    }
    return DEM_OK;
}

int dem_main_effects(struct dem_program *p, int argc, char **argv)
{
    if (p->rank != 0)
    {
        return DEM_OK;
    }
    if (argc > 0 && strcmp(argv[0], "-help") == 0)
    {
        fputs(help, stdout);
        return DEM_OK;
    }
    return print_effects(argc, argv);
}
