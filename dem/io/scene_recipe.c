/*
 * scene_recipe.c -- the physics of a scene: materials, effects with their settings, other settings for two materials.
 *
 * Which words an effect knows stands in the effect (effects/effect.h); what they come to, in state/recipe.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/scene_parts.h"
#include "base/error.h"
#include "base/unknown.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct dem_field material_fields[] =
{
    DEM_FIELD_AS(dem_material, density, "density", "kg/m3", DEM_FIELD_REQUIRED, DEM_ABOVE_ZERO, INFINITY, "mass per volume"),
    DEM_FIELD_AS(dem_material, youngs_modulus, "youngsModulus", "Pa", DEM_FIELD_REQUIRED, DEM_ABOVE_ZERO, INFINITY,
                 "Young's modulus; softer than real is common and faster"),
    DEM_FIELD_AS(dem_material, poissons_ratio, "poissonsRatio", "1", 0.3, 0.0, 0.49999, "Poisson's ratio"),
    DEM_FIELD_AS(dem_material, yield_strength, "yieldStrength", "Pa", 0.0, 0.0, INFINITY, "for the plan's word on yielding; 0: not told"),
    {0},
};

static int read_material(void *with, const struct dem_dict *dict)
{
    struct dem_material m = {.density = 0.0};

    DEM_REQUIRE(strlen(dem_dict_name(dict)) < sizeof m.name, DEM_ERROR_INPUT, "%s: material name longer than %zu letters",
                dem_dict_where(dict), sizeof m.name - 1);
    snprintf(m.name, sizeof m.name, "%s", dem_dict_name(dict));
    DEM_TRY(dem_dict_fields(dict, material_fields, &m));
    return dem_recipe_add_material(with, &m, dem_dict_where(dict));
}

static int set_field(struct dem_recipe *r, const int *pair, const char *effect, const struct dem_field *f,
                     const struct dem_dict *dict)
{
    const char *const where = dem_dict_where(dict), *word;
    double value[3];

    switch (f->kind)
    {
    case DEM_FIELD_NUMBER:
        DEM_TRY(dem_dict_number(dict, f->name, f->unit, value));
        return dem_recipe_set_number(r, pair, effect, f->name, value, 1, where);
    case DEM_FIELD_VECTOR:
        DEM_TRY(dem_dict_vector(dict, f->name, f->unit, value));
        return dem_recipe_set_number(r, pair, effect, f->name, value, 3, where);
    default:
        DEM_TRY(dem_dict_word(dict, f->name, &word));
        return dem_recipe_set_word(r, pair, effect, f->name, word, where);
    }
}

enum
{
    MOST_WORDS = 32                                       /* settings of one effect */
};

/* A word that is no setting of the effect: said at once, before a setting that it was meant to be is missed. */
static int refuse_unknown(const struct dem_effect *effect, const struct dem_dict *dict)
{
    const char *known[MOST_WORDS];
    int n = 0;

    for (const struct dem_field *f = effect->settings; f && f->name && n < MOST_WORDS; f++)
    {
        known[n++] = f->name;
    }
    for (size_t k = 0; k < dem_dict_count(dict); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(dict, k);

        if (!effect->settings || !dem_field_find(effect->settings, dem_entry_name(e)))
        {
            const int status = dem_unknown_word("setting", dem_entry_name(e), known, n);

            return dem_error_prefix(status, "%s, %s: ", dem_entry_where(e), effect->name);
        }
    }
    return DEM_OK;
}

static int set_fields(struct dem_recipe *r, const int *pair, const struct dem_effect *effect, const struct dem_dict *dict)
{
    DEM_TRY(refuse_unknown(effect, dict));
    for (const struct dem_field *f = effect->settings; f && f->name; f++)
    {
        if (dem_dict_has(dict, f->name))
        {
            DEM_TRY(set_field(r, pair, effect->name, f, dict));
        }
    }
    return DEM_OK;
}

static int read_effect(void *with, const struct dem_dict *dict)
{
    struct dem_recipe *const r = with;
    const char *const name = dem_dict_name(dict);

    DEM_TRY(dem_recipe_choose(r, name, dem_dict_where(dict)));
    for (int k = 0; k < r->chosen; k++)
    {
        if (strcmp(r->effect[k]->name, name) == 0)
        {
            return set_fields(r, NULL, r->effect[k], dict);
        }
    }
    return DEM_OK;
}

static int read_pair(void *with, const struct dem_dict *dict)
{
    struct dem_recipe *const r = with;
    const struct dem_dict *sub;
    const char *const *names;
    size_t n;
    int pair[2];

    DEM_TRY(dem_dict_words(dict, "between", &names, &n));
    DEM_REQUIRE(n == 2, DEM_ERROR_INPUT, "%s: between names %zu materials; name two, twice the same for contacts among itself",
                dem_dict_where(dict), n);
    for (int k = 0; k < 2; k++)
    {
        const int status = dem_recipe_material(r, names[k], "between", &pair[k]);

        DEM_TRY(status ? dem_error_prefix(status, "%s: %s: ", dem_dict_where(dict), dem_dict_path(dict)) : DEM_OK);
    }
    for (int k = 0; k < r->chosen; k++)
    {
        DEM_TRY(dem_dict_sub_if(dict, r->effect[k]->name, &sub));
        if (sub)
        {
            DEM_REQUIRE(r->effect[k]->stage < DEM_STAGE_BODY, DEM_ERROR_INPUT,
                        "%s: %s acts on single particles, not on pairs; set it in effects", dem_dict_where(sub), r->effect[k]->name);
            DEM_TRY(set_fields(r, pair, r->effect[k], sub));
        }
    }
    return DEM_OK;
}

/* ---- what others call ---------------------------------------------------------------------------------------- */

int dem_scene_read_materials(const struct dem_dict *scene, struct dem_recipe *r)
{
    DEM_TRY(dem_dict_each(scene, "materials", read_material, r));
    DEM_REQUIRE(r->materials > 0, DEM_ERROR_INPUT,
                "the scene has no materials; add materials { glass { density 2500; youngsModulus 1e7; } }");
    return DEM_OK;
}

int dem_scene_read_material_of(const struct dem_dict *dict, const struct dem_recipe *r, int *material)
{
    char list[256] = "";
    const char *name;

    if (dem_dict_has(dict, "material"))
    {
        DEM_TRY(dem_dict_word(dict, "material", &name));
        return dem_recipe_material(r, name, dem_dict_where(dict), material);
    }
    for (int k = 0; k < r->materials && strlen(list) < sizeof list - 64; k++)
    {
        snprintf(list + strlen(list), 64, "%s%s", k > 0 ? ", " : "", r->material[k].name);
    }
    DEM_REQUIRE(r->materials == 1, DEM_ERROR_INPUT, "%s: %s misses its material, as the scene has %d; add material, one of %s",
                dem_dict_where(dict), dem_dict_path(dict), r->materials, list);
    *material = 0;
    return DEM_OK;
}

int dem_scene_read_recipe(const struct dem_dict *scene, struct dem_recipe *r)
{
    DEM_TRY(dem_dict_each(scene, "effects", read_effect, r));
    return dem_dict_each(scene, "pairs", read_pair, r);
}
