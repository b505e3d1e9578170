/*
 * recipe_freeze.c -- from chosen effects to prepared chains, one chain a pair class.
 *
 * Memory columns are shared by name over all classes, so a row of contact memory has the same layout everywhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "state/recipe_parts.h"
#include "base/memory.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

int dem_effect_memories(const struct dem_effect *effect)
{
    int n = 0;

    while (effect->memory && effect->memory[n])
    {
        n++;
    }
    return n;
}

static double sphere_mass(const struct dem_material *m, double radius)
{
    return m->density*4.0/3.0*3.14159265358979323846*radius*radius*radius;
}

static struct dem_pair_class pair_class(const struct dem_recipe *r, int with_wall, int a, int b)
{
    const struct dem_material *const m = &r->material[a], *const o = &r->material[b];
    const double nm = m->poissons_ratio, no = o->poissons_ratio, Em = m->youngs_modulus, Eo = o->youngs_modulus;
    const double Ra = r->least_radius[a], Rb = r->least_radius[b];
    struct dem_pair_class c = {.a = m, .b = o, .with_wall = with_wall};

    c.reduced_modulus = 1.0/((1.0 - nm*nm)/Em + (1.0 - no*no)/Eo);
    c.reduced_shear = 1.0/(2.0*(2.0 - nm)*(1.0 + nm)/Em + 2.0*(2.0 - no)*(1.0 + no)/Eo);
    c.least_radius = with_wall ? Ra : Ra*Rb/(Ra + Rb);
    c.widest = r->most_radius[a] + (with_wall ? 0.0 : r->most_radius[b]);
    c.least_mass = with_wall ? sphere_mass(m, Ra) : 1.0/(1.0/sphere_mass(m, Ra) + 1.0/sphere_mass(o, Rb));
    return c;
}

static int add_link(struct dem_recipe *r, struct dem_chain *chain, int place, int memory, int a, int b)
{
    const struct dem_effect *const effect = r->effect[place];
    struct dem_link *const link = &chain->link[chain->links];
    const int contact = effect->stage < DEM_STAGE_BODY;

    DEM_TRY(dem_memory_new(&link->settings, 1, effect->size + 1));
    link->effect = effect;
    link->memory = memory;
    chain->links++;
    memcpy(link->settings, r->settings[place], effect->size);
    for (int k = 0; contact && k < r->overrides; k++)
    {
        const struct dem_override *const o = &r->override[k];
        const int this_pair = (o->pair[0] == a && o->pair[1] == b) || (o->pair[0] == b && o->pair[1] == a);

        if (o->effect == effect && this_pair)
        {
            DEM_TRY(dem_override_enter(o, link->settings));
        }
    }
    if (effect->settings)
    {
        const int status = dem_field_missing(effect->settings, link->settings, effect->name);

        if (status && contact)
        {
            const char *const x = chain->pair.a->name, *const y = chain->pair.b->name;

            return dem_error_prefix(status, "contact %s-%s, by effects or by pairs between (%s %s): ", x, y, x, y);
        }
        DEM_TRY(status);
    }
    chain->pair.exponent = effect->stage == DEM_STAGE_NORMAL ? effect->exponent : chain->pair.exponent;
    chain->needs |= effect->needs;
    chain->moments |= effect->stage == DEM_STAGE_MOMENT || effect->stage == DEM_STAGE_BOND;
    chain->past_touching |= effect->stage == DEM_STAGE_BOND || effect->stage == DEM_STAGE_FILM;
    return effect->prepare ? effect->prepare(link->settings, contact ? &chain->pair : NULL) : DEM_OK;
}

/* The step and the distance that one link asks for. */
static void bound(struct dem_recipe *r, const struct dem_chain *chain, const struct dem_link *link)
{
    const char *why = link->effect->name, *const place = chain->pair.with_wall ? ", at a wall" : "";
    const double reach = link->effect->reach ? link->effect->reach(link->settings, &chain->pair) : 0.0;
    const double limit = link->effect->time_limit ? link->effect->time_limit(link->settings, &chain->pair, &why)
                                                  : DBL_MAX;

    r->reach = reach > r->reach ? reach : r->reach;
    if (limit < r->step_limit)
    {
        r->next_limit = r->step_limit;
        memcpy(r->next_why, r->why, sizeof r->why);
        r->step_limit = limit;
        snprintf(r->why, sizeof r->why, "%s%s", why, place);
    }
    else if (limit < r->next_limit)
    {
        r->next_limit = limit;
        snprintf(r->next_why, sizeof r->next_why, "%s%s", why, place);
    }
}

static int build_chain(struct dem_recipe *r, struct dem_chain *chain, int a, int b, const int *first_memory)
{
    const int bodies = chain == &r->bodies;

    for (int k = 0; k < r->chosen; k++)
    {
        if (bodies == (r->effect[k]->stage >= DEM_STAGE_BODY))
        {
            DEM_TRY(add_link(r, chain, k, first_memory[k], a, b));
            bound(r, chain, &chain->link[chain->links - 1]);
        }
    }
    r->needs |= chain->needs;
    r->moments |= chain->moments;
    r->past_touching |= chain->past_touching;
    return DEM_OK;
}

static int add_class(struct dem_recipe *r, int with_wall, int a, int b, const int *first_memory)
{
    struct dem_chain *const chain = &r->chain[r->classes];

    chain->pair = pair_class(r, with_wall, a, b);
    r->class_of[with_wall][a][b] = r->classes;
    if (!with_wall)
    {
        r->class_of[0][b][a] = r->classes;
    }
    r->classes++;
    return build_chain(r, chain, a, b, first_memory);
}

static int name_memories(struct dem_recipe *r, int *first_memory)
{
    for (int k = 0; k < r->chosen; k++)
    {
        const int n = dem_effect_memories(r->effect[k]);

        DEM_REQUIRE(r->memories + n <= DEM_MEMORY_COLUMNS, DEM_ERROR_INPUT,
                    "the chosen effects remember more than %d numbers per contact; choose fewer", DEM_MEMORY_COLUMNS);
        first_memory[k] = r->memories;
        for (int m = 0; m < n; m++)
        {
            r->memory[r->memories++] = r->effect[k]->memory[m];
        }
    }
    return DEM_OK;
}

int dem_recipe_freeze(struct dem_recipe *r, const int wall_materials[DEM_MATERIALS])
{
    int first_memory[DEM_CHAIN];

    DEM_TRY(name_memories(r, first_memory));
    DEM_TRY(DEM_NEW(r->chain, 2*r->materials*r->materials + 1));
    memset(r->class_of, -1, sizeof r->class_of);
    r->step_limit = r->next_limit = DBL_MAX;
    snprintf(r->why, sizeof r->why, "no effect bounds it");
    for (int a = 0; a < r->materials; a++)
    {
        for (int b = a; b < r->materials; b++)
        {
            if (r->least_radius[a] > 0.0 && r->least_radius[b] > 0.0)
            {
                DEM_TRY(add_class(r, 0, a, b, first_memory));
            }
        }
    }
    for (int a = 0; a < r->materials; a++)
    {
        for (int b = 0; b < r->materials; b++)
        {
            if (r->least_radius[a] > 0.0 && wall_materials[b])
            {
                DEM_TRY(add_class(r, 1, a, b, first_memory));
            }
        }
    }
    return build_chain(r, &r->bodies, -1, -1, first_memory);
}

int dem_recipe_lend(const struct dem_recipe *r, struct dem_recipe *to)
{
    *to = *r;
    to->chain = NULL;
    DEM_TRY(DEM_NEW(to->chain, r->classes + 1));
    memcpy(to->chain, r->chain, (size_t)r->classes*sizeof *to->chain);
    for (int c = 0; c < r->classes; c++)
    {
        to->chain[c].pair.a = to->material + (r->chain[c].pair.a - r->material);
        to->chain[c].pair.b = to->material + (r->chain[c].pair.b - r->material);
    }
    return DEM_OK;
}

void dem_recipe_give_back(struct dem_recipe *r)
{
    dem_memory_free(r->chain);
    memset(r, 0, sizeof *r);
}

static void leave(struct dem_recipe *r, struct dem_chain *chain, const char *effect)
{
    const int links = chain->links;

    chain->links = 0;
    chain->needs = 0;
    chain->moments = chain->past_touching = 0;
    for (int k = 0; k < links; k++)
    {
        const struct dem_link link = chain->link[k];

        if (strcmp(link.effect->name, effect) != 0)
        {
            chain->link[chain->links++] = link;
            chain->needs |= link.effect->needs;
            chain->moments |= link.effect->stage == DEM_STAGE_MOMENT || link.effect->stage == DEM_STAGE_BOND;
            chain->past_touching |= link.effect->stage == DEM_STAGE_BOND || link.effect->stage == DEM_STAGE_FILM;
            r->reach = link.effect->reach ? fmax(r->reach, link.effect->reach(link.settings, &chain->pair)) : r->reach;
        }
    }
    r->needs |= chain->needs;
    r->moments |= chain->moments;
    r->past_touching |= chain->past_touching;
}

void dem_recipe_leave(struct dem_recipe *r, const char *effect)
{
    r->needs = 0;
    r->moments = r->past_touching = 0;
    r->reach = 0.0;
    for (int c = 0; c < r->classes; c++)
    {
        leave(r, &r->chain[c], effect);
    }
    leave(r, &r->bodies, effect);
}
