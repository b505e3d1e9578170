/*
 * scene_effects.c -- read the physics of a scene: materials, effects with their settings, settings
 * for pairs of materials.
 *
 * The settings of an effect are declared in the effect (laws/effect.h);
 * laws/interaction_table.h stores their values.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/scene_internal.h"
#include "core/error.h"
#include "core/did_you_mean.h"
#include "laws/effects.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct dem_setting material_settings[] = {
    DEM_SETTING_AS(dem_material, density, "density", "kg/m3", DEM_SETTING_REQUIRED, DEM_ABOVE_ZERO,
                   INFINITY, "mass per volume"),
    DEM_SETTING_AS(dem_material, youngs_modulus, "youngsModulus", "Pa", DEM_SETTING_REQUIRED,
                   DEM_ABOVE_ZERO, INFINITY,
                   "Young's modulus; softer than real is common and faster"),
    DEM_SETTING_AS(dem_material, poissons_ratio, "poissonsRatio", "1", 0.3, 0.0, 0.49999,
                   "Poisson's ratio"),
    DEM_SETTING_AS(dem_material, yield_strength, "yieldStrength", "Pa", 0.0, 0.0, INFINITY,
                   "for the plan's check of yielding; 0: unknown"),
    DEM_SETTING_AS(dem_material, thermal.conductivity, "conductivity", "W/(m K)", 0.0, 0.0,
                   INFINITY, "thermal conductivity"),
    DEM_SETTING_AS(dem_material, thermal.heat_capacity, "heatCapacity", "J/(kg K)", 0.0, 0.0,
                   INFINITY, "specific heat capacity"),
    DEM_SETTING_AS(dem_material, thermal.emissivity, "emissivity", "1", 0.0, 0.0, 1.0,
                   "emissivity of the surface"),
    DEM_SETTING_AS(dem_material, thermal.real_modulus, "realModulus", "Pa", 0.0, 0.0, INFINITY,
                   "Young's modulus of the real material, where youngsModulus is softer; 0: the same"),
    {0},
};

static int read_material(void *table, const struct dem_dict *dict)
{
    struct dem_material m = {.density = 0.0};

    DEM_REQUIRE(strlen(dem_dict_name(dict)) < sizeof m.name, DEM_ERROR_INPUT,
                "%s: material name longer than %zu characters", dem_dict_where(dict),
                sizeof m.name - 1);
    snprintf(m.name, sizeof m.name, "%s", dem_dict_name(dict));
    DEM_TRY(dem_dict_settings(dict, material_settings, &m));
    return dem_interaction_table_add_material(table, &m, dem_dict_where(dict));
}

static int read_setting(struct dem_interaction_table *r, const int *pair, const char *effect,
                        const struct dem_setting *f, const struct dem_dict *dict)
{
    const char *const where = dem_dict_where(dict), *word;
    double value[3];

    switch (f->kind)
    {
    case DEM_SETTING_NUMBER:
        DEM_TRY(dem_dict_number(dict, f->name, f->unit, value));
        return dem_interaction_table_set_number(r, pair, effect, f->name, value, 1, where);
    case DEM_SETTING_VECTOR:
        DEM_TRY(dem_dict_vector(dict, f->name, f->unit, value));
        return dem_interaction_table_set_number(r, pair, effect, f->name, value, 3, where);
    default:
        DEM_TRY(dem_dict_word(dict, f->name, &word));
        return dem_interaction_table_set_word(r, pair, effect, f->name, word, where);
    }
}

enum
{
    MAX_SETTINGS = 32  /* of one effect */
};

/* Refuse a word that is not a setting of the effect. Checked first: otherwise the message would
   be about the setting that is missing because it was misspelt. */
static int refuse_unknown(const struct dem_effect *effect, const struct dem_dict *dict)
{
    const char *known[MAX_SETTINGS];
    int n = 0;

    for (const struct dem_setting *f = effect->settings; f && f->name && n < MAX_SETTINGS; f++)
    {
        known[n++] = f->name;
    }
    for (size_t k = 0; k < dem_dict_count(dict); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(dict, k);

        if (!dem_settings_find(effect->settings, dem_entry_name(e)))
        {
            const int status = dem_did_you_mean_error("setting", dem_entry_name(e), known, n);

            return dem_error_prefix(status, "%s, %s: ", dem_entry_where(e), effect->name);
        }
    }
    return DEM_OK;
}

static int read_settings(struct dem_interaction_table *r, const int *pair,
                         const struct dem_effect *effect, const struct dem_dict *dict)
{
    DEM_TRY(refuse_unknown(effect, dict));
    for (const struct dem_setting *f = effect->settings; f && f->name; f++)
    {
        if (dem_dict_has(dict, f->name))
        {
            DEM_TRY(read_setting(r, pair, effect->name, f, dict));
        }
    }
    return DEM_OK;
}

static int read_effect(void *table, const struct dem_dict *dict)
{
    struct dem_interaction_table *const r = table;
    const char *const name = dem_dict_name(dict);

    DEM_TRY(dem_interaction_table_add_effect(r, name, dem_dict_where(dict)));
    for (int k = 0; k < r->chosen; k++)
    {
        if (r->effect[k] == dem_effects_find(name))
        {
            return read_settings(r, NULL, r->effect[k], dict);
        }
    }
    return DEM_OK;
}

/* A chosen effect by its word in another code; other unknown entries of a pair are refused as
   unread. */
static int refuse_alias(const struct dem_effect *effect, const struct dem_dict *dict)
{
    for (size_t k = 0; k < dem_dict_count(dict); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(dict, k);

        DEM_REQUIRE(!dem_effect_is_alias(effect, dem_entry_name(e)), DEM_ERROR_INPUT,
                    "%s: unknown entry \"%s\" in %s; did you mean %s?", dem_entry_where(e),
                    dem_entry_name(e), dem_dict_path(dict), effect->name);
    }
    return DEM_OK;
}

static int read_pair(void *table, const struct dem_dict *dict)
{
    struct dem_interaction_table *const r = table;
    const struct dem_dict *sub;
    const char *const *names;
    size_t n;
    int pair[2];

    DEM_TRY(dem_dict_words(dict, "between", &names, &n));
    DEM_REQUIRE(n == 2, DEM_ERROR_INPUT,
                "%s: between names %zu materials; name two, or the same one twice for contacts "
                "between its own particles",
                dem_dict_where(dict), n);
    for (int k = 0; k < 2; k++)
    {
        const int status = dem_interaction_table_find_material(r, names[k], "between", &pair[k]);

        DEM_TRY(
            status ? dem_error_prefix(status, "%s: %s: ", dem_dict_where(dict), dem_dict_path(dict))
                   : DEM_OK);
    }
    for (int k = 0; k < r->chosen; k++)
    {
        DEM_TRY(refuse_alias(r->effect[k], dict));
        DEM_TRY(dem_dict_sub_if(dict, r->effect[k]->name, &sub));
        if (!sub && r->effect[k]->short_name)
        {
            DEM_TRY(dem_dict_sub_if(dict, r->effect[k]->short_name, &sub));
        }
        if (sub)
        {
            DEM_REQUIRE(r->effect[k]->stage < DEM_STAGE_BODY, DEM_ERROR_INPUT,
                        "%s: %s acts on single particles, not on pairs; set it in effects",
                        dem_dict_where(sub), r->effect[k]->name);
            DEM_TRY(read_settings(r, pair, r->effect[k], sub));
        }
    }
    return DEM_OK;
}

static int has_effect(const struct dem_dict *pair, const struct dem_effect *e)
{
    return dem_dict_has(pair, e->name) || (e->short_name && dem_dict_has(pair, e->short_name));
}

/* Entries of `pairs` for the same two materials set different effects. */
static int refuse_both(const struct dem_interaction_table *r, const struct dem_dict *one, const struct dem_dict *two)
{
    const char *const *a, *const *b;
    size_t n;

    DEM_TRY(dem_dict_words(one, "between", &a, &n));
    DEM_TRY(dem_dict_words(two, "between", &b, &n));
    const int turned = strcmp(a[0], b[0]) != 0;
    const int same = strcmp(a[0], b[turned]) == 0 && strcmp(a[1], b[!turned]) == 0;

    for (int k = 0; same && k < r->chosen; k++)
    {
        const struct dem_effect *const e = r->effect[k];

        DEM_REQUIRE(!has_effect(one, e) || !has_effect(two, e), DEM_ERROR_INPUT,
                    "%s: %s and %s both set %s between %s and %s; keep one of the two", dem_dict_where(two),
                    dem_dict_path(one), dem_dict_path(two), e->name, a[0], a[1]);
    }
    return DEM_OK;
}

static int refuse_twice(const struct dem_interaction_table *r, const struct dem_dict *scene)
{
    const struct dem_dict *pairs;

    DEM_TRY(dem_dict_sub_if(scene, "pairs", &pairs));
    for (size_t two = 1; pairs && two < dem_dict_count(pairs); two++)
    {
        for (size_t one = 0; one < two; one++)
        {
            DEM_TRY(refuse_both(r, dem_entry_dict(dem_dict_entry(pairs, one)),
                                dem_entry_dict(dem_dict_entry(pairs, two))));
        }
    }
    return DEM_OK;
}

/* ---- interface ------------------------------------------------------------------------------- */

int dem_scene_read_materials(const struct dem_dict *scene, struct dem_interaction_table *r)
{
    DEM_TRY(dem_dict_each(scene, "materials", read_material, r));
    DEM_REQUIRE(r->materials > 0, DEM_ERROR_INPUT,
                "the scene has no materials; add materials { glass { density 2500; youngsModulus "
                "1e7; } }");
    return DEM_OK;
}

int dem_scene_read_interactions(const struct dem_dict *scene, struct dem_interaction_table *r)
{
    DEM_TRY(dem_dict_each(scene, "effects", read_effect, r));
    DEM_TRY(dem_dict_each(scene, "pairs", read_pair, r));
    return refuse_twice(r, scene);
}
