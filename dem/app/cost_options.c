/*
 * cost_options.c -- command-line options of `dem cost`: read and check them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* strtok_r */
#include "app/cost.h"
#include "core/did_you_mean.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const series_names[] = {"step", "stiffness", "precision", "friction"};

static const char *const option_names[DEM_COST_OPTIONS] = {"-window", "-budget", "-runs",
                                                           "-target", "-of", "-series",
                                                           "-steps", "-stiffnesses", "-folder",
                                                           "-effects"};

void dem_cost_options(struct dem_option option[DEM_COST_OPTIONS])
{
    for (int k = 0; k < DEM_COST_OPTIONS; k++)
    {
        option[k] = (struct dem_option){.name = option_names[k],
                                        .flag = k == DEM_COST_OPTION_EFFECTS,
                                        .alias = k == DEM_COST_OPTION_SERIES ? "-ladders" : NULL};
    }
}

static int read_number(const struct dem_option *o, double min, double max, double fallback,
                       double *value)
{
    char *end;

    *value = fallback;
    if (!o->given)
    {
        return DEM_OK;
    }
    *value = strtod(o->given, &end);
    DEM_REQUIRE(end != o->given && !*end && *value >= min && *value <= max, DEM_ERROR_INPUT,
                "%s %s; give a number from %g to %g", o->name, o->given, min, max);
    return DEM_OK;
}

static int descending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x < y) - (x > y);
}

/* Numbers separated by commas, 1 among them; sorted in descending order, as the largest is the
   coarsest. */
static int read_levels(const struct dem_option *o, const char *fallback, double *value, int *n)
{
    const char *text = o->given ? o->given : fallback;
    char *end;
    int has_one = 0;

    for (*n = 0; *text; text = *end ? end + 1 : end)
    {
        DEM_REQUIRE(*n < DEM_REFINEMENT_LEVELS, DEM_ERROR_INPUT, "%s %s; give at most %d numbers",
                    o->name, o->given, DEM_REFINEMENT_LEVELS);
        value[*n] = strtod(text, &end);
        DEM_REQUIRE(end != text && (!*end || *end == ',') && value[*n] >= 1e-6 && value[*n] <= 1e6,
                    DEM_ERROR_INPUT,
                    "%s %s; give numbers from 1e-6 to 1e6 separated by commas, as in %s", o->name,
                    o->given, fallback);
        has_one |= value[(*n)++] == 1.0;
    }
    qsort(value, (size_t)*n, sizeof *value, descending);
    for (int k = 1; k < *n; k++)
    {
        DEM_REQUIRE(value[k] < value[k - 1], DEM_ERROR_INPUT,
                    "%s %s has %g twice; give each level once", o->name, o->given, value[k]);
    }
    DEM_REQUIRE(*n >= 3 && has_one, DEM_ERROR_INPUT,
                "%s %s; give three levels or more, 1 (the scene as it is) among them", o->name,
                o->given);
    return DEM_OK;
}

/* Words separated by commas: selected[k] is 1 for those that are given. Without the option it is
   not changed. */
static int read_words(const struct dem_option *o, const char *what, const char *const *known, int n,
                      int *selected)
{
    char text[256], *word, *rest;

    if (!o->given)
    {
        return DEM_OK;
    }
    DEM_REQUIRE(o->given[0] && strlen(o->given) < sizeof text, DEM_ERROR_INPUT,
                "%s \"%s\"; give words separated by commas", o->name, o->given);
    snprintf(text, sizeof text, "%s", o->given);
    memset(selected, 0, (size_t)n*sizeof *selected);
    for (word = strtok_r(text, ",", &rest); word; word = strtok_r(NULL, ",", &rest))
    {
        int found = 0;

        for (int k = 0; k < n; k++)
        {
            found |= strcmp(word, known[k]) == 0;
            selected[k] |= strcmp(word, known[k]) == 0;
        }
        if (!found)
        {
            return dem_did_you_mean_error(what, word, known, n);
        }
    }
    return DEM_OK;
}

static int name_folder(struct dem_cost *c, const char *given)
{
    const char *const slash = strrchr(c->request.scene, '/');
    const char *const name = slash ? slash + 1 : c->request.scene;
    const char *const dot = strrchr(name, '.');
    const int length =
        given ? (int)strlen(given) : (int)(dot && dot > name ? dot - name : (long)strlen(name));

    DEM_REQUIRE(length > 0 && (size_t)length + 6 < sizeof c->folder, DEM_ERROR_INPUT,
                "a folder's name of %d characters; give another -folder", length);
    snprintf(c->folder, sizeof c->folder, "%.*s%s", length, given ? given : name,
             given ? "" : ".cost");
    return DEM_OK;
}

int dem_cost_read_options(struct dem_cost *c)
{
    static const char *const quantities[] = {"kinetic", "rotation", "height", "overlap",
                                             "force", "contacts", "restitution"};
    const struct dem_option *const o = c->request.option;
    double runs;

    DEM_TRY(read_number(&o[DEM_COST_OPTION_WINDOW], 0.0, DBL_MAX, 0.0, &c->window));
    DEM_REQUIRE(!o[DEM_COST_OPTION_WINDOW].given || c->window > 0.0, DEM_ERROR_INPUT,
                "-window %s; give a number of seconds above 0", o[DEM_COST_OPTION_WINDOW].given);
    DEM_TRY(read_number(&o[DEM_COST_OPTION_BUDGET], 0.1, 1e9, 60.0, &c->budget));
    DEM_TRY(read_number(&o[DEM_COST_OPTION_RUNS], 3.0, DEM_REFINEMENT_RUNS, 5.0, &runs));
    DEM_REQUIRE(runs == floor(runs), DEM_ERROR_INPUT, "-runs %g; give a whole number", runs);
    c->runs = (int)runs;
    DEM_TRY(read_number(&o[DEM_COST_OPTION_TARGET], 1e-12, 1.0, 0.01, &c->target));
    for (int k = 0; k < DEM_COST_SCENE_QUANTITIES; k++)
    {
        c->wanted[k] = 1;
    }
    DEM_TRY(read_words(&o[DEM_COST_OPTION_QUANTITIES], "quantity", quantities,
                       DEM_COST_SCENE_QUANTITIES, c->wanted));
    for (int k = 0; k < DEM_COST_NAMED_SERIES; k++)
    {
        c->selection.series[k] = !o[DEM_COST_OPTION_EFFECTS].given;
    }
    DEM_REQUIRE(!o[DEM_COST_OPTION_EFFECTS].given || !o[DEM_COST_OPTION_SERIES].given,
                DEM_ERROR_INPUT, "-effects and -series %s; give only one of them",
                o[DEM_COST_OPTION_SERIES].given);
    DEM_TRY(read_words(&o[DEM_COST_OPTION_SERIES], "series", series_names, DEM_COST_NAMED_SERIES,
                       c->selection.series));
    DEM_TRY(read_levels(&o[DEM_COST_OPTION_STEPS], "2,1,0.5,0.25,0.125", c->selection.steps,
                        &c->selection.step_levels));
    DEM_TRY(read_levels(&o[DEM_COST_OPTION_STIFFNESSES], "0.0625,0.25,1,4,16",
                        c->selection.stiffnesses, &c->selection.stiffness_levels));
    return name_folder(c, o[DEM_COST_OPTION_FOLDER].given);
}

