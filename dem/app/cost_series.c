/*
 * cost_series.c -- the refinement series of a scene: one parameter varied, level by level, with
 * several runs of each level.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* strtok_r, isatty */
#include "app/cost.h"
#include "effects/effects.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* Progress, only on a terminal. */
static void show_progress(const struct dem_cost *c, const char *text)
{
    if (c->prog->rank == 0 && isatty(STDERR_FILENO))
    {
        fputs(text, stderr);
        fflush(stderr);
    }
}

/* Runs of a level: with up to 4 % more and fewer steps, at least one step apart. A run that fails
   ends the level, and its error text is kept. */
static int run_level(const struct dem_cost *c, struct dem_cost_level *r,
                     struct dem_cost_variation k)
{
    const double steps = fmax(1.0, round(c->window/c->samples/r->step));
    const double spacing = fmax(1.0, round(0.08*steps/fmax(1.0, c->runs - 1.0)));

    for (r->runs = 0; r->runs < c->runs; r->runs++)
    {
        k.steps = (int64_t)fmax(1.0, steps + spacing*(r->runs - (c->runs - 1)/2));
        if (dem_cost_run(c, &k, &r->run[r->runs]))
        {
            snprintf(r->failed, sizeof r->failed, "%s", dem_error_text());
            r->runs = 0;
            return DEM_OK;
        }
    }
    show_progress(c, ".");
    return DEM_OK;
}

static struct dem_cost_series *new_series(struct dem_cost *c, const char *parameter,
                                          const char *description)
{
    struct dem_cost_series *const l = &c->series[c->n_series++];

    snprintf(l->parameter, sizeof l->parameter, "%s", parameter);
    snprintf(l->description, sizeof l->description, "%s", description);
    snprintf(l->entry, sizeof l->entry, "time/step");
    l->base = -1;
    memcpy(l->reported, c->wanted, sizeof l->reported);
    return l;
}

static int run_steps(struct dem_cost *c)
{
    struct dem_cost_series *const l =
        new_series(c, "step", "time step, in steps of the scene as it is");

    l->exact = 1;
    for (int k = 0; k < c->selection.step_levels; k++)
    {
        struct dem_cost_level *const r = &l->level[l->levels++];

        l->base = c->selection.steps[k] == 1.0 ? k : l->base;
        snprintf(r->name, sizeof r->name, "%.4g", c->selection.steps[k]);
        r->size = c->selection.steps[k];
        r->step = c->step*c->selection.steps[k];
        DEM_TRY(run_level(c, r, (struct dem_cost_variation){.stiffness_factor = 1.0}));
    }
    return DEM_OK;
}

/* The step over its limit is the same in all levels, so the error of the step is much the same in
   all. Soft first. */
static int run_stiffnesses(struct dem_cost *c)
{
    struct dem_cost_series *const l =
        new_series(c, "stiffness", "stiffness, in that of the scene; errors against hard spheres");

    l->reported[DEM_COST_OVERLAP] = 0;    /* hard spheres have none */
    for (int k = c->selection.stiffness_levels - 1; k >= 0; k--)
    {
        struct dem_cost_level *const r = &l->level[l->levels];
        double limit;

        l->base = c->selection.stiffnesses[k] == 1.0 ? l->levels : l->base;
        l->levels++;
        snprintf(r->name, sizeof r->name, "%.4g", c->selection.stiffnesses[k]);
        DEM_TRY(dem_cost_step_limit(c, c->selection.stiffnesses[k], &limit));
        r->size = limit/c->limit;
        r->step = c->step*r->size;
        DEM_TRY(run_level(c, r,
                          (struct dem_cost_variation){
                              .stiffness_factor = c->selection.stiffnesses[k]}));
    }
    return DEM_OK;
}

static int run_precisions(struct dem_cost *c)
{
    struct dem_cost_series *const l =
        new_series(c, "precision", "precision; errors against double");

    for (int k = 0; k < 2; k++)
    {
        struct dem_cost_level *const r = &l->level[l->levels++];

        snprintf(r->name, sizeof r->name, "%s", k ? "double" : "mixed");
        r->size = k ? 0.5 : 1.0;
        r->step = c->step;
        DEM_TRY(
            run_level(c, r,
                      (struct dem_cost_variation){.stiffness_factor = 1.0, .precision = r->name}));
    }
    l->base = 1;
    l->paired = 1;
    return DEM_OK;
}

/* ---- laws of friction, effects --------------------------------------------------------------- */

/* Keep the settings of the scene's law that all laws have. */
static int read_friction(struct dem_cost_friction *f, const char *name, const struct dem_dict *law)
{
    static const char *const known[] = {"friction", "tangentialDamping", "adhesion"};

    f->law = name;
    f->settings = 0;
    for (size_t e = 0; e < dem_dict_count(law); e++)
    {
        const struct dem_entry *const entry = dem_dict_entry(law, e);

        for (int n = 0; n < DEM_COST_FRICTION_SETTINGS; n++)
        {
            if (strcmp(dem_entry_name(entry), known[n]) == 0 && dem_entry_tokens(entry) == 1)
            {
                char (*const setting)[64] = f->setting[f->settings++];
                const char *const value = dem_entry_token(entry, 0);

                DEM_REQUIRE(strlen(value) < sizeof setting[1], DEM_ERROR_INPUT,
                            "%s: %s has a value of more than %zu characters; write the number "
                            "shorter",
                            dem_entry_where(entry), known[n], sizeof setting[1] - 1);
                snprintf(setting[0], sizeof setting[0], "%s", known[n]);
                snprintf(setting[1], sizeof setting[1], "%s", value);
            }
        }
    }
    return DEM_OK;
}

int dem_cost_find_friction(struct dem_cost *c, const struct dem_dict *scene)
{
    const struct dem_dict *effects, *law;

    c->friction.law = NULL;
    DEM_TRY(dem_dict_sub_if(scene, "effects", &effects));
    for (const struct dem_effect *const *e = dem_effects;
         *e && effects && !dem_dict_has(scene, "pairs"); e++)
    {
        law = NULL;
        DEM_TRY((*e)->stage == DEM_STAGE_TANGENT ? dem_dict_sub_if(effects, (*e)->name, &law)
                                                 : DEM_OK);
        DEM_TRY(law ? read_friction(&c->friction, (*e)->name, law) : DEM_OK);
    }
    DEM_REQUIRE(c->friction.law || !c->selection.series[3]
                    || !c->request.option[DEM_COST_OPTION_SERIES].given,
                DEM_ERROR_INPUT,
                "-series friction: the scene has no law of friction, or settings of its own for "
                "some pairs; leave it out");
    return DEM_OK;
}

static struct dem_cost_level *new_level(const struct dem_cost *c, struct dem_cost_series *l,
                                        const char *format, const char *name)
{
    struct dem_cost_level *const r = &l->level[l->levels];

    snprintf(r->name, sizeof r->name, format, name);
    r->step = c->step;
    r->size = DEM_REFINEMENT_LEVELS - l->levels++;    /* only identifies the level */
    return r;
}

/* The scene's own law comes last: the others are compared with it. */
static int run_friction(struct dem_cost *c)
{
    struct dem_cost_series *const l = new_series(c, "friction",
                                                 "law of friction, with the same settings; changes "
                                                 "against the scene's");

    for (const struct dem_effect *const *e = dem_effects; *e; e++)
    {
        if ((*e)->stage == DEM_STAGE_TANGENT && strcmp((*e)->name, c->friction.law) != 0)
        {
            const struct dem_cost_variation k = {.stiffness_factor = 1.0, .friction = (*e)->name};

            DEM_TRY(run_level(c, new_level(c, l, "%s", (*e)->name), k));
        }
    }
    l->base = l->levels;
    l->paired = 1;
    return run_level(c, new_level(c, l, "%s", c->friction.law),
                     (struct dem_cost_variation){.stiffness_factor = 1.0});
}

static int run_effects(struct dem_cost *c)
{
    struct dem_cost_series *const l =
        new_series(c, "effects", "without each effect in turn; changes against the scene as it is");
    char acting[sizeof c->acting], *word, *rest;

    snprintf(acting, sizeof acting, "%s", c->acting);
    for (word = strtok_r(acting, " ", &rest); word && l->levels < DEM_REFINEMENT_LEVELS - 1;
         word = strtok_r(NULL, " ", &rest))
    {
        DEM_TRY(run_level(c, new_level(c, l, "%s", word),
                          (struct dem_cost_variation){.stiffness_factor = 1.0, .without = word}));
    }
    l->base = l->levels;
    l->paired = 1;
    return run_level(c, new_level(c, l, "%s", "all"),
                     (struct dem_cost_variation){.stiffness_factor = 1.0});
}

/* ---- all of them ----------------------------------------------------------------------------- */

static int wants_stiffness(const struct dem_cost *c)
{
    if (c->from_snapshot)    /* its overlaps belong to its own stiffness */
    {
        return 0;
    }
    /* without a step limit no contact is stiff; the result of a head-on impact does not depend on
       stiffness */
    return c->selection.series[1] && c->limit < DBL_MAX
        && (c->impact.bodies == 0 || c->request.option[DEM_COST_OPTION_SERIES].given);
}

double dem_cost_relative(const struct dem_cost *c)
{
    double sum = c->selection.series[2] ? 2.0 : 0.0;

    for (int k = 0; k < c->selection.step_levels && c->selection.series[0]; k++)
    {
        sum += 1.0/c->selection.steps[k];
    }
    for (int k = 0; k < c->selection.stiffness_levels && wants_stiffness(c); k++)
    {
        /* number of steps: contact time ~ E^-0.4 */
        sum += pow(c->selection.stiffnesses[k], 0.4);
    }
    sum += c->selection.series[3] && c->friction.law ? 3.0 : 0.0;
    for (const char *text = c->acting; *text && c->request.option[DEM_COST_OPTION_EFFECTS].given;
         text++)
    {
        sum += *text == ' ' || text == c->acting ? 1.0 : 0.0;
    }
    sum += c->request.option[DEM_COST_OPTION_EFFECTS].given ? 1.0 : 0.0;
    return c->runs*sum;
}

int dem_cost_run_series(struct dem_cost *c)
{
    DEM_TRY(c->selection.series[0] ? run_steps(c) : DEM_OK);
    DEM_TRY(wants_stiffness(c) ? run_stiffnesses(c) : DEM_OK);
    DEM_TRY(c->selection.series[2] ? run_precisions(c) : DEM_OK);
    DEM_TRY(c->selection.series[3] && c->friction.law ? run_friction(c) : DEM_OK);
    DEM_TRY(c->request.option[DEM_COST_OPTION_EFFECTS].given ? run_effects(c) : DEM_OK);
    show_progress(c, "\n");
    return DEM_OK;
}
