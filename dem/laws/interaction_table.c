/*
 * interaction_table.c -- materials, chosen effects and their settings: what is added before the
 * freeze.
 *
 * The effect lists of pair classes are built from these in interaction_table_freeze.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/interaction_table_internal.h"
#include "core/aliases.h"
#include "core/memory.h"
#include "laws/effects.h"
#include "laws/fluid/viscosity.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

void dem_interaction_table_init(struct dem_interaction_table *r)
{
    memset(r, 0, sizeof *r);
}

static void free_list(struct dem_effect_list *list)
{
    for (int k = 0; k < list->entries; k++)
    {
        dem_memory_free(list->entry[k].settings);
    }
    list->entries = 0;
}

void dem_interaction_table_free(struct dem_interaction_table *r)
{
    for (int k = 0; k < r->chosen; k++)
    {
        dem_memory_free(r->settings[k]);
    }
    for (int c = 0; c < r->classes; c++)
    {
        free_list(&r->list[c]);
    }
    free_list(&r->bodies);
    dem_memory_free(r->list);
    dem_memory_free(r->override);
    memset(r, 0, sizeof *r);
}

/* ---- materials and effects ------------------------------------------------------------------- */

int dem_interaction_table_add_material(struct dem_interaction_table *r,
                                       const struct dem_material *m, const char *where)
{
    DEM_REQUIRE(r->materials < DEM_MATERIALS, DEM_ERROR_INPUT,
                "%s: more than %d materials; merge equal ones", where, DEM_MATERIALS);
    for (int k = 0; k < r->materials; k++)
    {
        DEM_REQUIRE(strcmp(r->material[k].name, m->name) != 0, DEM_ERROR_INPUT,
                    "%s: material %s is given twice; rename one of them", where, m->name);
    }
    r->material[r->materials++] = *m;
    return DEM_OK;
}

int dem_interaction_table_find_material(const struct dem_interaction_table *r, const char *name,
                                        const char *where, int *material)
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
    const int status = dem_did_you_mean_error("material", name, known, r->materials);
    return dem_error_prefix(status, "%s: ", where);
}

static int index_of(const struct dem_interaction_table *r, const char *name)
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
    return a->excludes && dem_alias_is_among(a->excludes, b->name);
}

int dem_interaction_table_excludes(const struct dem_interaction_table *r,
                                   const struct dem_effect *effect)
{
    for (int k = 0; k < r->chosen; k++)
    {
        if (excludes(effect, r->effect[k]) || excludes(r->effect[k], effect))
        {
            return 1;
        }
    }
    return 0;
}

int dem_interaction_table_find_scalar(const struct dem_interaction_table *r, const char *name)
{
    for (int k = 0; k < r->scalars; k++)
    {
        if (strcmp(r->scalar[k]->name, name) == 0)
        {
            return k;
        }
    }
    return -1;
}

/* A scalar, unless it is there already; *at: its index. */
static int add_scalar(struct dem_interaction_table *r, const struct dem_scalar *s,
                      const char *where, int *at)
{
    const int known = dem_interaction_table_find_scalar(r, s->name);

    *at = known < 0 ? r->scalars : known;
    DEM_REQUIRE(*at < DEM_SCALARS, DEM_ERROR_INPUT,
                "%s: the effects need more than %d particle scalars; choose fewer effects", where,
                DEM_SCALARS);
    DEM_REQUIRE(known >= 0 || s->batch.body || r->scalars == r->listed, DEM_ERROR_INPUT,
                "%s: the particle scalar %s comes after those with columns in batches; list it before "
                "them", where, s->name);
    r->scalar[*at] = s;
    r->scalars += known < 0;
    r->listed += known < 0 && !s->batch.body;
    return DEM_OK;
}

static int add_scalars(struct dem_interaction_table *r, const struct dem_effect *effect,
                       const char *where)
{
    int at;

    for (int k = 0; effect->scalars && effect->scalars[k]; k++)
    {
        DEM_TRY(add_scalar(r, effect->scalars[k], where, &at));
        r->exchanged[at] |= effect->stage == DEM_STAGE_FLUID && effect->scalars[k]->exchange;
    }
    return DEM_OK;
}

double dem_interaction_table_own_viscosity(const struct dem_interaction_table *r,
                                           const struct dem_effect *effect)
{
    return effect->needs & DEM_NEEDS_VISCOSITY
             ? dem_interaction_table_get_number(r, effect->name, "viscosity")
             : 0.0;
}

const struct dem_effect *dem_interaction_table_fluid_user(const struct dem_interaction_table *r)
{
    const struct dem_effect *user = NULL;

    for (int k = 0; k < r->chosen; k++)
    {
        const struct dem_effect *const e = r->effect[k];

        user = e->needs & DEM_NEEDS_FLUID ||
                       (e->needs & DEM_NEEDS_VISCOSITY &&
                        dem_interaction_table_own_viscosity(r, e) == 0.0)
                   ? e
                   : user;
    }
    return user;
}

int dem_interaction_table_add_fluid_scalars(struct dem_interaction_table *r, const char *where)
{
    int at;

    return dem_interaction_table_fluid_user(r) ? add_scalar(r, &dem_fluid_viscosity, where, &at)
                                               : DEM_OK;
}

int dem_interaction_table_use_parcels(struct dem_interaction_table *r, double ratio,
                                      const char *where)
{
    r->parcels.used = 1;
    r->parcels.ratio = ratio;
    return add_scalar(r, &dem_parcel_ratio, where, &r->parcels.scalar);
}

void dem_interaction_table_add_parcel(struct dem_interaction_table *r, double ratio)
{
    struct dem_parcels_entry *const p = &r->parcels;

    p->min = p->min > 0.0 ? fmin(p->min, ratio) : ratio;
    p->max = fmax(p->max, ratio);
}

int dem_interaction_table_add_effect(struct dem_interaction_table *r, const char *name,
                                     const char *where)
{
    const struct dem_effect *const effect = dem_effects_find(name);
    int index = r->chosen;

    if (!effect)
    {
        return dem_effects_unknown(where, name);
    }
    DEM_REQUIRE(index_of(r, name) < 0, DEM_ERROR_INPUT, "%s: effect %s is chosen twice; keep one",
                where, name);
    DEM_REQUIRE(r->chosen < DEM_EFFECT_LIST_LIMIT, DEM_ERROR_INPUT, "%s: more than %d effects",
                where, DEM_EFFECT_LIST_LIMIT);
    for (int k = 0; k < r->chosen; k++)
    {
        const int exclusive = effect->stage == DEM_STAGE_NORMAL || effect->stage == DEM_STAGE_DAMP
                       || effect->stage == DEM_STAGE_TANGENT;

        DEM_REQUIRE(!(exclusive && r->effect[k]->stage == effect->stage) &&
                        !(effect->drag && r->effect[k]->drag) &&
                        !(effect->transfers && r->effect[k]->transfers == effect->transfers),
                    DEM_ERROR_INPUT, "%s: %s and %s are of the same kind; choose only one of them",
                    where, r->effect[k]->name, name);
        DEM_REQUIRE(
            !excludes(effect, r->effect[k]) && !excludes(r->effect[k], effect), DEM_ERROR_INPUT,
            "%s: %s and %s model the same force or dissipation, which would count twice; choose only one of them",
            where, r->effect[k]->name, name);
    }
    while (index > 0 && r->effect[index - 1]->stage > effect->stage)
    {
        r->effect[index] = r->effect[index - 1];
        r->settings[index] = r->settings[index - 1];
        index--;
    }
    r->effect[index] = effect;
    DEM_TRY(dem_memory_new(&r->settings[index], 1, effect->size + 1));
    r->chosen++;
    dem_settings_set_defaults(effect->settings, r->settings[index]);
    return add_scalars(r, effect, where);
}

int dem_interaction_table_has_effect(const struct dem_interaction_table *r, const char *effect)
{
    return index_of(r, effect) >= 0;
}

int dem_effect_list_has_law(const struct dem_effect_list *list)
{
    int normal = 0;

    for (int k = 0; k < list->entries; k++)
    {
        normal |= list->entry[k].effect->stage == DEM_STAGE_NORMAL;
    }
    return normal;
}

int dem_interaction_table_wall_has_law(const struct dem_interaction_table *r,
                                       enum dem_partner wall, int wall_material)
{
    int all = 1;

    for (int m = 0; m < r->materials; m++)
    {
        const int c = r->class_of[wall][m][wall_material];

        all &= c < 0 || r->max_radius[m] <= 0.0 || dem_effect_list_has_law(&r->list[c]);
    }
    return all;
}

int dem_interaction_table_has_pressure_gradient(const struct dem_interaction_table *r)
{
    int has = 0;

    for (int k = 0; k < r->chosen; k++)
    {
        has |= r->effect[k]->has_pressure_gradient;
    }
    return has;
}

unsigned dem_interaction_table_needs(const struct dem_interaction_table *r)
{
    unsigned needs = 0;

    for (int k = 0; k < r->chosen; k++)
    {
        needs |= r->effect[k]->needs |
                 (r->effect[k]->extra_needs ? r->effect[k]->extra_needs(r->settings[k]) : 0);
    }
    return needs;
}

double dem_interaction_table_get_number(const struct dem_interaction_table *r, const char *effect,
                                        const char *entry)
{
    const int index = index_of(r, effect);

    return index < 0 ? NAN
                     : dem_settings_number(r->effect[index]->settings, r->settings[index], entry);
}

const struct dem_effect *dem_interaction_table_gravity(const struct dem_interaction_table *r,
                                                       double g[3])
{
    const struct dem_effect *first = NULL;

    g[0] = g[1] = g[2] = 0.0;
    for (int e = 0; e < r->chosen; e++)
    {
        double one[3];

        if (r->effect[e]->uniform_acceleration)
        {
            r->effect[e]->uniform_acceleration(r->settings[e], one);
            for (int k = 0; k < 3; k++)
            {
                g[k] = first ? g[k] + one[k] : one[k];
            }
            first = first ? first : r->effect[e];
        }
    }
    return first;
}

/* ---- settings -------------------------------------------------------------------------------- */

static int set_entry(const struct dem_effect *effect, void *settings, const char *entry,
                     const double *values, int count, const char *word, const char *where)
{
    const struct dem_setting *const fields = effect->settings;
    const int status =
        word ? dem_settings_set_word(fields, settings, effect->name, entry, word)
             : dem_settings_set_number(fields, settings, effect->name, entry, values, count);

    return status ? dem_error_prefix(status, "%s: ", where) : DEM_OK;
}

int dem_override_apply(const struct dem_override *o, void *settings)
{
    return set_entry(o->effect, settings, o->entry, o->values, o->count,
                     o->word[0] ? o->word : NULL, o->where);
}

static int set_for_pair(struct dem_interaction_table *r, const int pair[2], const char *effect,
                        const char *entry, const double *values, int count, const char *word,
                        const char *where)
{
    const int index = index_of(r, effect);
    struct dem_override o = {.count = count};

    DEM_REQUIRE(index >= 0, DEM_ERROR_INPUT,
                "%s: %s is not among the chosen effects; add it to effects", where, effect);
    if (!pair)
    {
        return set_entry(r->effect[index], r->settings[index], entry, values, count, word, where);
    }
    DEM_REQUIRE(r->overrides < DEM_OVERRIDES, DEM_ERROR_INPUT,
                "%s: more than %d settings for pairs", where, DEM_OVERRIDES);
    if (!r->override)
    {
        DEM_TRY(DEM_NEW(r->override, DEM_OVERRIDES));
    }
    memcpy(o.pair, pair, sizeof o.pair);
    o.effect = r->effect[index];
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

int dem_interaction_table_set_number(struct dem_interaction_table *r, const int pair[2],
                                     const char *effect, const char *entry, const double *values,
                                     int count, const char *where)
{
    return set_for_pair(r, pair, effect, entry, values, count, NULL, where);
}

int dem_interaction_table_set_word(struct dem_interaction_table *r, const int pair[2],
                                   const char *effect, const char *entry, const char *word,
                                   const char *where)
{
    return set_for_pair(r, pair, effect, entry, NULL, 0, word, where);
}
