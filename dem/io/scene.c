/*
 * scene.c -- one function a word.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/scene.h"
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
    {0},
};

/* Call `read` for each sub-dictionary of scene/name, if there is one. */
static int each(const struct dem_dict *scene, const char *name, int (*read)(void *, const struct dem_dict *), void *with)
{
    const struct dem_dict *list;

    DEM_TRY(dem_dict_sub_if(scene, name, &list));
    for (size_t k = 0; list && k < dem_dict_count(list); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(list, k);

        DEM_REQUIRE(dem_entry_is_dict(e), DEM_ERROR_INPUT, "%s: %s holds dictionaries; write %s { ... }", dem_entry_where(e),
                    name, dem_entry_name(e));
        DEM_TRY(read(with, dem_entry_dict(e)));
    }
    return DEM_OK;
}

/* ---- materials, effects, pairs ------------------------------------------------------------------------------- */

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
        DEM_TRY(dem_recipe_material(r, names[k], dem_dict_where(dict), &pair[k]));
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

/* ---- walls --------------------------------------------------------------------------------------------------- */

struct wall_reader
{
    struct dem_recipe *recipe;
    struct dem_walls *walls;
};

/* Six planes that look inward: one wall a side, named after the box. */
static int read_box(struct dem_walls *w, const struct dem_dict *dict, int material)
{
    static const char *const side[2][3] = {{"MinX", "MinY", "MinZ"}, {"MaxX", "MaxY", "MaxZ"}};
    double corner[2][3];

    DEM_TRY(dem_dict_vector(dict, "min", "m", corner[0]));
    DEM_TRY(dem_dict_vector(dict, "max", "m", corner[1]));
    for (int k = 0; k < 6; k++)
    {
        double normal[3] = {0.0, 0.0, 0.0};
        char name[64];

        DEM_REQUIRE(corner[0][k%3] < corner[1][k%3], DEM_ERROR_INPUT, "%s: min %g is not below max %g along axis %d",
                    dem_dict_where(dict), corner[0][k%3], corner[1][k%3], k%3);
        normal[k%3] = k < 3 ? 1.0 : -1.0;
        snprintf(name, sizeof name, "%.50s%s", dem_dict_name(dict), side[k/3][k%3]);
        DEM_TRY(dem_walls_add_plane(w, name, material, corner[k/3], normal));
    }
    return DEM_OK;
}

static int read_triangles(struct dem_walls *w, const struct dem_dict *dict, int material)
{
    const double (*corner)[3];
    size_t n;
    int wall;

    DEM_TRY(dem_dict_vectors(dict, "corners", "m", &corner, &n));
    DEM_REQUIRE(n > 0 && n%3 == 0, DEM_ERROR_INPUT, "%s: %zu corners; give three for each triangle", dem_dict_where(dict), n);
    DEM_TRY(dem_walls_add(w, dem_dict_name(dict), material, &wall));
    return dem_walls_add_triangles(w, wall, n/3, &corner[0][0]);
}

static int is_there(const struct dem_walls *w, const char *name)
{
    for (int k = 0; k < w->walls; k++)
    {
        if (strcmp(w->wall[k].name, name) == 0)
        {
            return 1;
        }
    }
    return 0;
}

static int read_wall(void *with, const struct dem_dict *dict)
{
    static const char *const known[] = {"plane", "box", "triangles", "patch"};
    struct wall_reader *const reader = with;
    const struct dem_recipe *const r = reader->recipe;
    const char *type, *name;
    double point[3], normal[3];
    int material;

    DEM_TRY(dem_dict_word(dict, "type", &type));
    DEM_TRY(dem_dict_word_or(dict, "material", r->materials == 1 ? r->material[0].name : "", &name));
    DEM_TRY(dem_recipe_material(r, name, dem_dict_where(dict), &material));
    if (strcmp(type, "plane") == 0)
    {
        DEM_TRY(dem_dict_vector(dict, "point", "m", point));
        DEM_TRY(dem_dict_vector(dict, "normal", "1", normal));
        return dem_walls_add_plane(reader->walls, dem_dict_name(dict), material, point, normal);
    }
    if (strcmp(type, "box") == 0)
    {
        return read_box(reader->walls, dict, material);
    }
    if (strcmp(type, "triangles") == 0)
    {
        return read_triangles(reader->walls, dict, material);
    }
    if (strcmp(type, "patch") == 0)
    {
        DEM_REQUIRE(is_there(reader->walls, dem_dict_name(dict)), DEM_ERROR_INPUT,
                    "%s: wall %s is a patch, but no mesh has given it; run it in OpenFOAM, or use type plane, box or triangles",
                    dem_dict_where(dict), dem_dict_name(dict));
        return DEM_OK;
    }
    return dem_error_prefix(dem_unknown_word("type of wall", type, known, 4), "%s: ", dem_dict_where(dict));
}

/* ---- domain, fluid, time ------------------------------------------------------------------------------------- */

static int read_periodic(struct dem_domain *d, const struct dem_dict *dict)
{
    const char *const *axis;
    size_t n;

    if (!dem_dict_has(dict, "periodic"))
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_words(dict, "periodic", &axis, &n));
    for (size_t k = 0; k < n; k++)
    {
        static const char *const known[] = {"x", "y", "z"};
        const int a = axis[k][0] - 'x';

        if (a < 0 || a > 2 || axis[k][1])
        {
            return dem_error_prefix(dem_unknown_word("periodic axis", axis[k], known, 3), "%s: ", dem_dict_where(dict));
        }
        DEM_REQUIRE(isfinite(d->max[a] - d->min[a]), DEM_ERROR_INPUT, "%s: axis %s is periodic but has no limits; give min and max",
                    dem_dict_where(dict), axis[k]);
        d->periodic[a] = 1;
        d->length[a] = d->max[a] - d->min[a];
    }
    return DEM_OK;
}

static int read_domain(struct dem_domain *d, const struct dem_dict *scene)
{
    static const char *const known[] = {"error", "remove"};
    const struct dem_dict *dict;
    const char *leaving;

    DEM_TRY(dem_dict_sub_if(scene, "domain", &dict));
    if (!dict)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_vector(dict, "min", "m", d->min));
    DEM_TRY(dem_dict_vector(dict, "max", "m", d->max));
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(d->min[k] < d->max[k], DEM_ERROR_INPUT, "%s: min %g m is not below max %g m along axis %d",
                    dem_dict_where(dict), d->min[k], d->max[k], k);
    }
    DEM_TRY(dem_dict_word_or(dict, "leaving", "error", &leaving));
    d->remove = strcmp(leaving, "remove") == 0;
    if (!d->remove && strcmp(leaving, "error") != 0)
    {
        return dem_error_prefix(dem_unknown_word("way of leaving", leaving, known, 2), "%s: ", dem_dict_where(dict));
    }
    return read_periodic(d, dict);
}

static int read_fluid(struct dem_uniform_fluid *f, const struct dem_dict *scene, const struct dem_recipe *r)
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    const struct dem_dict *dict;
    double hydrostatic[3];

    DEM_TRY(dem_dict_sub_if(scene, "fluid", &dict));
    if (!dict)
    {
        return DEM_OK;
    }
    f->given = 1;
    DEM_TRY(dem_dict_vector_or(dict, "velocity", "m/s", zero, f->velocity));
    DEM_TRY(dem_dict_number(dict, "density", "kg/m3", &f->density));
    DEM_TRY(dem_dict_number(dict, "viscosity", "Pa s", &f->viscosity));
    DEM_TRY(dem_dict_number_or(dict, "voidFraction", "1", 1.0, &f->void_fraction));
    DEM_REQUIRE(f->density > 0.0 && f->viscosity > 0.0 && f->void_fraction > 0.0 && f->void_fraction <= 1.0, DEM_ERROR_INPUT,
                "%s: density %g kg/m3, viscosity %g Pa s, voidFraction %g; all must be above 0, the last at most 1",
                dem_dict_where(dict), f->density, f->viscosity, f->void_fraction);
    /* a fluid at rest under the scene's gravity carries its own weight */
    dem_recipe_vector(r, "gravity", "acceleration", hydrostatic);
    for (int k = 0; k < 3; k++)
    {
        hydrostatic[k] *= f->density;
    }
    return dem_dict_vector_or(dict, "pressureGradient", "Pa/m", hydrostatic, f->pressure_gradient);
}

static int read_time(struct dem_scene *s, const struct dem_dict *scene)
{
    const struct dem_dict *dict;
    const char *step;

    s->most_overlap = 0.5;
    DEM_TRY(dem_dict_sub_if(scene, "time", &dict));
    if (!dict)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_number_or(dict, "maxOverlap", "1", s->most_overlap, &s->most_overlap));
    DEM_TRY(dem_dict_switch_or(dict, "force", false, &s->force));
    DEM_TRY(dem_dict_word_or(dict, "step", "auto", &step));
    if (strcmp(step, "auto") != 0)
    {
        DEM_TRY(dem_dict_number(dict, "step", "s", &s->step));
        DEM_REQUIRE(s->step > 0.0, DEM_ERROR_INPUT, "%s: step %g s; give a number above 0, or auto", dem_dict_where(dict), s->step);
    }
    return DEM_OK;
}

static int read_neighbours(struct dem_scene *s, const struct dem_dict *scene)
{
    const struct dem_dict *dict;

    s->outer_skin = 0.3;
    s->inner_skin = 0.04;
    DEM_TRY(dem_dict_sub_if(scene, "neighbours", &dict));
    if (!dict)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_number_or(dict, "outerSkin", "1", s->outer_skin, &s->outer_skin));
    DEM_TRY(dem_dict_number_or(dict, "innerSkin", "1", s->inner_skin, &s->inner_skin));
    DEM_REQUIRE(s->inner_skin > 0.0 && s->outer_skin >= s->inner_skin && s->outer_skin <= 2.0, DEM_ERROR_INPUT,
                "%s: outerSkin %g, innerSkin %g (of a diameter); give 0 < innerSkin <= outerSkin <= 2", dem_dict_where(dict),
                s->outer_skin, s->inner_skin);
    return DEM_OK;
}

/* ---- the whole ----------------------------------------------------------------------------------------------- */

int dem_scene_read(struct dem_scene *s, const struct dem_dict *scene, struct dem_recipe *r, struct dem_walls *w,
                   struct dem_domain *d)
{
    struct wall_reader walls = {.recipe = r, .walls = w};
    const struct dem_dict *insert, *start;

    DEM_TRY(each(scene, "effects", read_effect, r));
    DEM_TRY(each(scene, "pairs", read_pair, r));
    DEM_TRY(each(scene, "walls", read_wall, &walls));
    DEM_TRY(read_domain(d, scene));
    DEM_TRY(read_fluid(&s->fluid, scene, r));
    DEM_TRY(read_time(s, scene));
    DEM_TRY(read_neighbours(s, scene));
    DEM_TRY(dem_dict_sub_if(scene, "start", &start));
    if (start)
    {
        DEM_TRY(dem_dict_text(start, "snapshot", &s->snapshot));
    }
    DEM_TRY(dem_dict_sub_if(scene, "insert", &insert));
    DEM_REQUIRE(!start || !insert, DEM_ERROR_INPUT, "%s: the scene has both start and insert; keep one", dem_dict_where(start));
    return insert ? dem_insert_read(&s->crowd, insert, r) : DEM_OK;
}

int dem_scene_read_materials(const struct dem_dict *scene, struct dem_recipe *r)
{
    DEM_TRY(each(scene, "materials", read_material, r));
    DEM_REQUIRE(r->materials > 0, DEM_ERROR_INPUT,
                "the scene has no materials; add materials { glass { density 2500; youngsModulus 1e7; } }");
    return DEM_OK;
}

void dem_scene_free(struct dem_scene *s)
{
    dem_crowd_free(&s->crowd);
}
