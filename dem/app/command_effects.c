/*
 * effects.c -- `dem effects`: list the effects with their settings, or what each costs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/main.h"
#include "core/error.h"
#include "dem.h"
#include <stdio.h>
#include <string.h>

static const double measuring_time = 0.5;    /* s of processor time an effect */

static const char help[] =
    "Usage: dem effects [NAME ...]\n"
    "       dem effects -cost [NAME ...]\n\n"
    "Lists all effects, or those named: name, stage, what it does, source; then each\n"
    "setting with unit, default, range and meaning. The names are those of the scene's\n"
    "effects { ... }.\n\n"
    "    -cost   the cost of each effect instead, measured now: nanoseconds per particle\n"
    "            and per contact, fraction of the step, bytes\n";

/* Print the text of one effect, or of all (NULL); with `cost` its measured cost. */
static int print_effect(struct dem *d, const char *effect, int cost)
{
    const char *text;

    DEM_TRY(cost ? dem_effect_cost_text(d, effect, measuring_time, &text)
                 : dem_effect_text(d, effect, &text));
    fputs(text, stdout);
    fflush(stdout);
    return DEM_OK;
}

static int print_effects(struct dem *d, int names, char **name, int cost)
{
    const char *known;

    for (int k = 0; k < names; k++)    /* all of them are known before one is measured */
    {
        DEM_TRY(dem_effect_text(d, name[k], &known));
    }
    if (cost || names == 0)
    {
        DEM_TRY(print_effect(d, NULL, cost));
    }
    for (int k = 0; k < names; k++)
    {
        DEM_TRY(print_effect(d, name[k], cost));
    }
    for (int k = 0; cost && names == 0 && (known = dem_effect_name(k)) != NULL; k++)
    {
        DEM_TRY(print_effect(d, known, cost));
    }
    return DEM_OK;
}

int dem_main_effects(struct dem_program *p, int argc, char **argv)
{
    struct dem *d;

    if (p->rank != 0)
    {
        return DEM_OK;
    }
    if (argc > 0 && strcmp(argv[0], "-help") == 0)
    {
        fputs(help, stdout);
        return DEM_OK;
    }
    const int cost = argc > 0 && strcmp(argv[0], "-cost") == 0;

    DEM_TRY(dem_create(&d, MPI_COMM_NULL));
    const int status = print_effects(d, argc - cost, argv + cost, cost);

    dem_free(d);
    return status;
}
