/*
 * recipe.c -- materials, chosen effects and their settings. What becomes of them is in recipe_freeze.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "state/recipe_parts.h"
#include "base/memory.h"
#include "effects/effects.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

void dem_recipe_init(struct dem_recipe *r)
{
    memset(r, 0, sizeof *r);
}

static void free_chain(struct dem_chain *chain)
{
    for (int k = 0; k < chain->links; k++)
    {
        dem_memory_free(chain->link[k].settings);
    }
    chain->links = 0;
}

void dem_recipe_free(struct dem_recipe *r)
{
    for (int k = 0; k < r->chosen; k++)
    {
        dem_memory_free(r->settings[k]);
    }
    for (int c = 0; c < r->classes; c++)
    {
        free_chain(&r->chain[c]);
    }
    free_chain(&r->bodies);
    dem_memory_free(r->chain);
    dem_memory_free(r->override);
    memset(r, 0, sizeof *r);
}

/* ---- choosing ------------------------------------------------------------------------------------------------ */

int dem_recipe_add_material(struct dem_recipe *r, const struct dem_material *m, const char *where)
{
    DEM_REQUIRE(r->materials < DEM_MATERIALS, DEM_ERROR_INPUT, "%s: more than %d materials; merge those that are alike",
                where, DEM_MATERIALS);
    for (int k = 0; k < r->materials; k++)
    {
        DEM_REQUIRE(strcmp(r->material[k].name, m->name) != 0, DEM_ERROR_INPUT,
                    "%s: material %s is given twice; rename one of them", where, m->name);
    }
    r->material[r->materials++] = *m;
    return DEM_OK;
}

int dem_recipe_material(const struct dem_recipe *r, const char *name, const char *where, int *material)
{
    const char *known[DEM_MATERIALS];

    for (int k = 0; k < r->materials; k++)
    {
        known[k] = r->material[k].name;
        if (strcmp(known[k], name) == 0)
        {
            *material = k;
            return DEM_OK;
        }
    }
    const int status = dem_unknown_word("material", name, known, r->materials);
    return dem_error_prefix(status, "%s: ", where);
}

static int place_of(const struct dem_recipe *r, const char *name)
{
    for (int k = 0; k < r->chosen; k++)
    {
        if (strcmp(r->effect[k]->name, name) == 0)
        {
            return k;
        }
    }
    return -1;
}

static int excludes(const struct dem_effect *a, const struct dem_effect *b)
{
    return a->excludes && strcmp(a->excludes, b->name) == 0;
}

int dem_recipe_choose(struct dem_recipe *r, const char *name, const char *where)
{
    const struct dem_effect *const effect = dem_effects_find(name);
    int place = r->chosen;

    if (!effect)
    {
        return dem_effects_unknown(where, name);
    }
    DEM_REQUIRE(place_of(r, name) < 0, DEM_ERROR_INPUT, "%s: effect %s is chosen twice; keep one", where, name);
    DEM_REQUIRE(r->chosen < DEM_CHAIN, DEM_ERROR_INPUT, "%s: more than %d effects", where, DEM_CHAIN);
    for (int k = 0; k < r->chosen; k++)
    {
        const int alone = effect->stage == DEM_STAGE_NORMAL || effect->stage == DEM_STAGE_DAMP
                       || effect->stage == DEM_STAGE_TANGENT;

        DEM_REQUIRE(!(alone && r->effect[k]->stage == effect->stage) && !(effect->drag && r->effect[k]->drag), DEM_ERROR_INPUT,
                    "%s: %s and %s are of the same kind; choose one of them", where, r->effect[k]->name, name);
        DEM_REQUIRE(!excludes(effect, r->effect[k]) && !excludes(r->effect[k], effect), DEM_ERROR_INPUT,
                    "%s: %s and %s both stand for the same loss, which would count twice; choose one of them", where,
                    r->effect[k]->name, name);
    }
    while (place > 0 && r->effect[place - 1]->stage > effect->stage)
    {
        r->effect[place] = r->effect[place - 1];
        r->settings[place] = r->settings[place - 1];
        place--;
    }
    r->effect[place] = effect;
    DEM_TRY(dem_memory_new(&r->settings[place], 1, effect->size + 1));
    r->chosen++;
    if (effect->settings)
    {
        dem_field_defaults(effect->settings, r->settings[place]);
    }
    return DEM_OK;
}

int dem_recipe_acts(const struct dem_recipe *r, const char *effect)
{
    return place_of(r, effect) >= 0;
}

unsigned dem_recipe_asks(const struct dem_recipe *r)
{
    unsigned needs = 0;

    for (int k = 0; k < r->chosen; k++)
    {
        needs |= r->effect[k]->needs | (r->effect[k]->asks ? r->effect[k]->asks(r->settings[k]) : 0);
    }
    return needs;
}

static const double *number_of(const struct dem_recipe *r, const char *effect, const char *entry)
{
    const int place = place_of(r, effect);
    const struct dem_field *const field = place < 0 || !r->effect[place]->settings ? NULL
                                        : dem_field_find(r->effect[place]->settings, entry);

    return field ? (const double *)(const void *)((const char *)r->settings[place] + field->offset) : NULL;
}

double dem_recipe_number(const struct dem_recipe *r, const char *effect, const char *entry)
{
    const double *const number = number_of(r, effect, entry);

    return number ? *number : NAN;
}

int dem_recipe_word(const struct dem_recipe *r, const char *effect, const char *entry, const char *word)
{
    const int place = place_of(r, effect);
    const struct dem_field *const field = place < 0 ? NULL : dem_field_find(r->effect[place]->settings, entry);
    int choice;

    if (!field)
    {
        return -1;
    }
    memcpy(&choice, (const char *)r->settings[place] + field->offset, sizeof choice);
    return choice >= 0 && strcmp(field->choices[choice], word) == 0;
}

void dem_recipe_vector(const struct dem_recipe *r, const char *effect, const char *entry, double value[3])
{
    const double *const number = number_of(r, effect, entry);

    for (int k = 0; k < 3; k++)
    {
        value[k] = number ? number[k] : 0.0;
    }
}

/* ---- numbers ------------------------------------------------------------------------------------------------- */

static const struct dem_field no_settings[] = {{0}};

static int set(const struct dem_effect *effect, void *settings, const char *entry, const double *values, int count,
               const char *word, const char *where)
{
    const struct dem_field *const fields = effect->settings ? effect->settings : no_settings;
    const int status = word ? dem_field_set_word(fields, settings, effect->name, entry, word)
                            : dem_field_set_number(fields, settings, effect->name, entry, values, count);

    return status ? dem_error_prefix(status, "%s: ", where) : DEM_OK;
}

int dem_override_enter(const struct dem_override *o, void *settings)
{
    return set(o->effect, settings, o->entry, o->values, o->count, o->word[0] ? o->word : NULL, o->where);
}

static int set_or_note(struct dem_recipe *r, const int pair[2], const char *effect, const char *entry,
                       const double *values, int count, const char *word, const char *where)
{
    const int place = place_of(r, effect);
    struct dem_override o = {.count = count};

    DEM_REQUIRE(place >= 0, DEM_ERROR_INPUT, "%s: %s is not among the chosen effects; add it to effects", where, effect);
    if (!pair)
    {
        return set(r->effect[place], r->settings[place], entry, values, count, word, where);
    }
    DEM_REQUIRE(r->overrides < DEM_CHOICES, DEM_ERROR_INPUT, "%s: more than %d settings for pairs", where, DEM_CHOICES);
    if (!r->override)
    {
        DEM_TRY(DEM_NEW(r->override, DEM_CHOICES));
    }
    memcpy(o.pair, pair, sizeof o.pair);
    o.effect = r->effect[place];
    snprintf(o.entry, sizeof o.entry, "%s", entry);
    snprintf(o.word, sizeof o.word, "%s", word ? word : "");
    snprintf(o.where, sizeof o.where, "%s", where);
    for (int k = 0; k < count && k < 3; k++)
    {
        o.values[k] = values[k];
    }
    r->override[r->overrides++] = o;
    return DEM_OK;
}

int dem_recipe_set_number(struct dem_recipe *r, const int pair[2], const char *effect, const char *entry,
                          const double *values, int count, const char *where)
{
    return set_or_note(r, pair, effect, entry, values, count, NULL, where);
}

int dem_recipe_set_word(struct dem_recipe *r, const int pair[2], const char *effect, const char *entry,
                        const char *word, const char *where)
{
    return set_or_note(r, pair, effect, entry, NULL, 0, word, where);
}
