/*
 * main_cost_ladders.c -- the scene with one knob turned, rung by rung.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* strtok_r, isatty */
#include "main_cost.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const char *const laws[] = {"mindlin", "mindlinIncremental", "linear"};

/* For whoever waits at a terminal. */
static void show_life(const struct dem_cost *c, const char *text)
{
    if (c->prog->rank == 0 && isatty(STDERR_FILENO))
    {
        fputs(text, stderr);
        fflush(stderr);
    }
}

/* Runs of up to 4 % more and less steps, however many they are, and one apart at least. One that fails ends its rung, and is told. */
static int climb(const struct dem_cost *c, struct dem_cost_rung *r, struct dem_cost_knobs k)
{
    const double steps = fmax(1.0, round(c->window/c->looks/r->step)), apart = fmax(1.0, round(0.08*steps/fmax(1.0, c->runs - 1.0)));

    for (r->runs = 0; r->runs < c->runs; r->runs++)
    {
        k.steps = (int64_t)fmax(1.0, steps + apart*(r->runs - (c->runs - 1)/2));
        if (dem_cost_run(c, &k, &r->run[r->runs]))
        {
            snprintf(r->failed, sizeof r->failed, "%s", dem_error_text());
            r->runs = 0;
            return DEM_OK;
        }
    }
    show_life(c, ".");
    return DEM_OK;
}

static struct dem_cost_ladder *new_ladder(struct dem_cost *c, const char *knob, const char *says)
{
    struct dem_cost_ladder *const l = &c->ladder[c->ladders++];

    snprintf(l->knob, sizeof l->knob, "%s", knob);
    snprintf(l->says, sizeof l->says, "%s", says);
    snprintf(l->entry, sizeof l->entry, "time/step");
    l->base = -1;
    memcpy(l->told, c->wanted, sizeof l->told);
    return l;
}

static int climb_steps(struct dem_cost *c)
{
    struct dem_cost_ladder *const l = new_ladder(c, "step", "time step, in steps of the scene as it is");

    l->exact = 1;
    for (int k = 0; k < c->wish.step_rungs; k++)
    {
        struct dem_cost_rung *const r = &l->rung[l->rungs++];

        l->base = c->wish.steps[k] == 1.0 ? k : l->base;
        snprintf(r->name, sizeof r->name, "%.4g", c->wish.steps[k]);
        r->size = c->wish.steps[k];
        r->step = c->step*c->wish.steps[k];
        DEM_TRY(climb(c, r, (struct dem_cost_knobs){.stiffer = 1.0}));
    }
    return DEM_OK;
}

/* The step is as long beside its limit in all rungs: what it errs by is much the same in all. Soft first. */
static int climb_stiffnesses(struct dem_cost *c)
{
    struct dem_cost_ladder *const l = new_ladder(c, "stiffness", "stiffness, in that of the scene; errors against hard spheres");

    l->told[DEM_COST_OVERLAP] = 0;                        /* there are none */
    for (int k = c->wish.stiffness_rungs - 1; k >= 0; k--)
    {
        struct dem_cost_rung *const r = &l->rung[l->rungs];
        double limit;

        l->base = c->wish.stiffnesses[k] == 1.0 ? l->rungs : l->base;
        l->rungs++;
        snprintf(r->name, sizeof r->name, "%.4g", c->wish.stiffnesses[k]);
        DEM_TRY(dem_cost_limit(c, c->wish.stiffnesses[k], &limit));
        r->size = limit/c->limit;
        r->step = c->step*r->size;
        DEM_TRY(climb(c, r, (struct dem_cost_knobs){.stiffer = c->wish.stiffnesses[k]}));
    }
    return DEM_OK;
}

static int climb_precisions(struct dem_cost *c)
{
    struct dem_cost_ladder *const l = new_ladder(c, "precision", "precision; errors against double");

    for (int k = 0; k < 2; k++)
    {
        struct dem_cost_rung *const r = &l->rung[l->rungs++];

        snprintf(r->name, sizeof r->name, "%s", k ? "double" : "mixed");
        r->size = k ? 0.5 : 1.0;
        r->step = c->step;
        DEM_TRY(climb(c, r, (struct dem_cost_knobs){.stiffer = 1.0, .precision = r->name}));
    }
    l->base = 1;
    l->paired = 1;
    return DEM_OK;
}

/* ---- laws of friction, effects ----------------------------------------------------------------------------------- */

int dem_cost_find_friction(struct dem_cost *c, const struct dem_dict *scene)
{
    static const char *const known[] = {"friction", "tangentialDamping", "adhesion"};
    const struct dem_dict *effects, *law;

    c->friction.law = NULL;
    DEM_TRY(dem_dict_sub_if(scene, "effects", &effects));
    for (size_t k = 0; k < sizeof laws/sizeof laws[0] && effects && !dem_dict_has(scene, "pairs"); k++)
    {
        DEM_TRY(dem_dict_sub_if(effects, laws[k], &law));
        c->friction.law = law ? laws[k] : c->friction.law;
        for (int n = 0; n < 3 && law; n++)
        {
            for (size_t e = 0; e < dem_dict_count(law); e++)
            {
                const struct dem_entry *const entry = dem_dict_entry(law, e);

                if (strcmp(dem_entry_name(entry), known[n]) == 0 && dem_entry_tokens(entry) == 1)
                {
                    snprintf(c->friction.setting[c->friction.settings][0], 64, "%s", known[n]);
                    snprintf(c->friction.setting[c->friction.settings++][1], 64, "%s", dem_entry_token(entry, 0));
                }
            }
        }
    }
    DEM_REQUIRE(c->friction.law || !c->wish.ladder[3] || !c->request.option[DEM_ASK_WHICH].given, DEM_ERROR_INPUT,
                "-ladders friction: the scene has no law of friction, or settings of its own for some pairs; leave it out");
    return DEM_OK;
}

static struct dem_cost_rung *new_rung(const struct dem_cost *c, struct dem_cost_ladder *l, const char *format, const char *name)
{
    struct dem_cost_rung *const r = &l->rung[l->rungs];

    snprintf(r->name, sizeof r->name, format, name);
    r->step = c->step;
    r->size = DEM_LADDER_RUNGS - l->rungs++;              /* told apart by it, no more */
    return r;
}

/* The scene's own comes last: the others are compared with it. */
static int climb_friction(struct dem_cost *c)
{
    struct dem_cost_ladder *const l = new_ladder(c, "friction", "law of friction, with the same settings; changes against the scene's");

    for (size_t k = 0; k < sizeof laws/sizeof laws[0]; k++)
    {
        if (strcmp(laws[k], c->friction.law) != 0)
        {
            DEM_TRY(climb(c, new_rung(c, l, "%s", laws[k]), (struct dem_cost_knobs){.stiffer = 1.0, .friction = laws[k]}));
        }
    }
    l->base = l->rungs;
    l->paired = 1;
    return climb(c, new_rung(c, l, "%s", c->friction.law), (struct dem_cost_knobs){.stiffer = 1.0});
}

static int climb_effects(struct dem_cost *c)
{
    struct dem_cost_ladder *const l = new_ladder(c, "effects", "without each effect in turn; changes against the scene as it is");
    char acting[sizeof c->acting], *word, *rest;

    snprintf(acting, sizeof acting, "%s", c->acting);
    for (word = strtok_r(acting, " ", &rest); word && l->rungs < DEM_LADDER_RUNGS - 1; word = strtok_r(NULL, " ", &rest))
    {
        DEM_TRY(climb(c, new_rung(c, l, "%s", word), (struct dem_cost_knobs){.stiffer = 1.0, .without = word}));
    }
    l->base = l->rungs;
    l->paired = 1;
    return climb(c, new_rung(c, l, "%s", "all"), (struct dem_cost_knobs){.stiffer = 1.0});
}

/* ---- all of them ----------------------------------------------------------------------------------------------- */

static int wants_stiffness(const struct dem_cost *c)
{
    if (c->from_snapshot)                                 /* whose overlaps are those of its own stiffness */
    {
        return 0;
    }
    /* without a limit nothing is stiff in it; and what comes of a head-on impact owes nothing to stiffness */
    return c->wish.ladder[1] && c->limit < DBL_MAX && (c->pair.bodies == 0 || c->request.option[DEM_ASK_WHICH].given);
}

double dem_cost_weight(const struct dem_cost *c)
{
    double sum = c->wish.ladder[2] ? 2.0 : 0.0;

    for (int k = 0; k < c->wish.step_rungs && c->wish.ladder[0]; k++)
    {
        sum += 1.0/c->wish.steps[k];
    }
    for (int k = 0; k < c->wish.stiffness_rungs && wants_stiffness(c); k++)
    {
        sum += pow(c->wish.stiffnesses[k], 0.4);          /* as contact times go */
    }
    sum += c->wish.ladder[3] && c->friction.law ? 3.0 : 0.0;
    for (const char *at = c->acting; *at && c->request.option[DEM_ASK_EFFECTS].given; at++)
    {
        sum += *at == ' ' || at == c->acting ? 1.0 : 0.0;
    }
    sum += c->request.option[DEM_ASK_EFFECTS].given ? 1.0 : 0.0;
    return c->runs*sum;
}

int dem_cost_climb(struct dem_cost *c)
{
    DEM_TRY(c->wish.ladder[0] ? climb_steps(c) : DEM_OK);
    DEM_TRY(wants_stiffness(c) ? climb_stiffnesses(c) : DEM_OK);
    DEM_TRY(c->wish.ladder[2] ? climb_precisions(c) : DEM_OK);
    DEM_TRY(c->wish.ladder[3] && c->friction.law ? climb_friction(c) : DEM_OK);
    DEM_TRY(c->request.option[DEM_ASK_EFFECTS].given ? climb_effects(c) : DEM_OK);
    show_life(c, "\n");
    return DEM_OK;
}
