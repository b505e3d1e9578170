/*
 * main_cost_options.c -- what may be asked of `dem cost`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* strtok_r */
#include "main_cost.h"
#include "base/unknown.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const ladders[] = {"step", "stiffness", "precision", "friction"};

static const char *const names[DEM_ASK_OPTIONS] = {"-window", "-budget", "-runs", "-target", "-of", "-ladders", "-steps", "-stiffnesses", "-folder",
                                                    "-effects"};

void dem_cost_options(struct dem_option option[DEM_ASK_OPTIONS])
{
    for (int k = 0; k < DEM_ASK_OPTIONS; k++)
    {
        option[k] = (struct dem_option){.name = names[k], .flag = k == DEM_ASK_EFFECTS};
    }
}

static int read_number(const struct dem_option *o, double least, double most, double fallback, double *value)
{
    char *end;

    *value = fallback;
    if (!o->given)
    {
        return DEM_OK;
    }
    *value = strtod(o->given, &end);
    DEM_REQUIRE(end != o->given && !*end && *value >= least && *value <= most, DEM_ERROR_INPUT, "%s %s; give a number from %g to %g", o->name,
                o->given, least, most);
    return DEM_OK;
}

static int descending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x < y) - (x > y);
}

/* Numbers with commas, and 1 among them; the first is the coarsest. */
static int read_rungs(const struct dem_option *o, const char *fallback, double *value, int *n)
{
    const char *at = o->given ? o->given : fallback;
    char *end;
    int one = 0;

    for (*n = 0; *at; at = *end ? end + 1 : end)
    {
        DEM_REQUIRE(*n < DEM_LADDER_RUNGS, DEM_ERROR_INPUT, "%s %s; give at most %d numbers", o->name, o->given, DEM_LADDER_RUNGS);
        value[*n] = strtod(at, &end);
        DEM_REQUIRE(end != at && (!*end || *end == ',') && value[*n] >= 1e-6 && value[*n] <= 1e6, DEM_ERROR_INPUT,
                    "%s %s; give numbers from 1e-6 to 1e6 with commas between, as in %s", o->name, o->given, fallback);
        one |= value[(*n)++] == 1.0;
    }
    qsort(value, (size_t)*n, sizeof *value, descending);
    for (int k = 1; k < *n; k++)
    {
        DEM_REQUIRE(value[k] < value[k - 1], DEM_ERROR_INPUT, "%s %s has %g twice; give each rung once", o->name, o->given, value[k]);
    }
    DEM_REQUIRE(*n >= 3 && one, DEM_ERROR_INPUT, "%s %s; give three rungs or more, 1 (the scene as it is) among them", o->name, o->given);
    return DEM_OK;
}

/* Words with commas: chosen[k] is 1 for those that are there. Without the option it is left as it is. */
static int read_words(const struct dem_option *o, const char *what, const char *const *known, int n, int *chosen)
{
    char text[256], *word, *rest;

    if (!o->given)
    {
        return DEM_OK;
    }
    DEM_REQUIRE(o->given[0] && strlen(o->given) < sizeof text, DEM_ERROR_INPUT, "%s \"%s\"; give words with commas between", o->name, o->given);
    snprintf(text, sizeof text, "%s", o->given);
    memset(chosen, 0, (size_t)n*sizeof *chosen);
    for (word = strtok_r(text, ",", &rest); word; word = strtok_r(NULL, ",", &rest))
    {
        int found = 0;

        for (int k = 0; k < n; k++)
        {
            found |= strcmp(word, known[k]) == 0;
            chosen[k] |= strcmp(word, known[k]) == 0;
        }
        if (!found)
        {
            return dem_unknown_word(what, word, known, n);
        }
    }
    return DEM_OK;
}

static int name_folder(struct dem_cost *c, const char *given)
{
    const char *const slash = strrchr(c->request.scene, '/'), *const name = slash ? slash + 1 : c->request.scene;
    const char *const dot = strrchr(name, '.');
    const int length = given ? (int)strlen(given) : (int)(dot && dot > name ? dot - name : (long)strlen(name));

    DEM_REQUIRE(length > 0 && (size_t)length + 6 < sizeof c->folder, DEM_ERROR_INPUT, "a folder's name of %d letters; give another -folder", length);
    snprintf(c->folder, sizeof c->folder, "%.*s%s", length, given ? given : name, given ? "" : ".cost");
    return DEM_OK;
}

int dem_cost_read_options(struct dem_cost *c)
{
    static const char *const quantities[] = {"kinetic", "rotation", "height", "overlap", "force", "contacts", "restitution"};
    const struct dem_option *const o = c->request.option;
    double runs;

    DEM_TRY(read_number(&o[DEM_ASK_WINDOW], 0.0, DBL_MAX, 0.0, &c->window));
    DEM_REQUIRE(!o[DEM_ASK_WINDOW].given || c->window > 0.0, DEM_ERROR_INPUT, "-window %s; give a number of seconds above 0", o[DEM_ASK_WINDOW].given);
    DEM_TRY(read_number(&o[DEM_ASK_BUDGET], 0.1, 1e9, 60.0, &c->budget));
    DEM_TRY(read_number(&o[DEM_ASK_RUNS], 3.0, DEM_LADDER_RUNS, 5.0, &runs));
    DEM_REQUIRE(runs == floor(runs), DEM_ERROR_INPUT, "-runs %g; give a whole number", runs);
    c->runs = (int)runs;
    DEM_TRY(read_number(&o[DEM_ASK_TARGET], 1e-12, 1.0, 0.01, &c->target));
    for (int k = 0; k < DEM_COST_OWN; k++)
    {
        c->wanted[k] = 1;
    }
    DEM_TRY(read_words(&o[DEM_ASK_OF], "quantity", quantities, DEM_COST_OWN, c->wanted));
    for (int k = 0; k < DEM_COST_LADDERS; k++)
    {
        c->wish.ladder[k] = !o[DEM_ASK_EFFECTS].given;
    }
    DEM_REQUIRE(!o[DEM_ASK_EFFECTS].given || !o[DEM_ASK_WHICH].given, DEM_ERROR_INPUT, "-effects and -ladders %s; ask for one of both",
                o[DEM_ASK_WHICH].given);
    DEM_TRY(read_words(&o[DEM_ASK_WHICH], "ladder", ladders, DEM_COST_LADDERS, c->wish.ladder));
    DEM_TRY(read_rungs(&o[DEM_ASK_STEPS], "2,1,0.5,0.25,0.125", c->wish.steps, &c->wish.step_rungs));
    DEM_TRY(read_rungs(&o[DEM_ASK_STIFFNESSES], "0.0625,0.25,1,4,16", c->wish.stiffnesses, &c->wish.stiffness_rungs));
    return name_folder(c, o[DEM_ASK_FOLDER].given);
}

