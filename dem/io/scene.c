/*
 * scene.c -- a scene from its beginning to its end; here also what is short: domain, fluid, time, neighbours, start.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/scene.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/unknown.h"
#include "io/scene_parts.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* `min (x y z); max (x y z);`, or only the axes that are limited, each by itself: `x (0 0.1);`. The others stay open. */
static int read_limits(struct dem_domain *d, const struct dem_dict *dict)
{
    static const char *const axis[] = {"x", "y", "z"};
    const bool corners = dem_dict_has(dict, "min") || dem_dict_has(dict, "max");
    int axes = 0;

    for (int k = 0; k < 3; k++)
    {
        const double *limit;
        size_t n;

        if (dem_dict_has(dict, axis[k]))
        {
            DEM_TRY(dem_dict_numbers(dict, axis[k], "m", &limit, &n));
            DEM_REQUIRE(n == 2, DEM_ERROR_INPUT, "%s: domain/%s has %zu numbers; give two, %s (min max)", dem_dict_where(dict), axis[k],
                        n, axis[k]);
            DEM_REQUIRE(!corners, DEM_ERROR_INPUT, "%s: domain has min or max and %s, which give the same twice; keep min and max, or "
                        "x, y, z", dem_dict_where(dict), axis[k]);
            d->min[k] = limit[0];
            d->max[k] = limit[1];
            axes++;
        }
    }
    if (corners || axes == 0)
    {
        DEM_TRY(dem_dict_vector(dict, "min", "m", d->min));
        DEM_TRY(dem_dict_vector(dict, "max", "m", d->max));
    }
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(d->min[k] < d->max[k], DEM_ERROR_INPUT, "%s: domain: min %g m is not below max %g m along %s",
                    dem_dict_where(dict), d->min[k], d->max[k], axis[k]);
    }
    return DEM_OK;
}

/* The axes of a list, which need limits. */
static int read_axes(const struct dem_domain *d, const struct dem_dict *dict, const char *list, int found[3])
{
    const char *const *axis;
    size_t n;

    if (!dem_dict_has(dict, list))
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_words(dict, list, &axis, &n));
    for (size_t k = 0; k < n; k++)
    {
        static const char *const known[] = {"x", "y", "z"};
        const int a = axis[k][0] - 'x';

        if (a < 0 || a > 2 || axis[k][1])
        {
            char what[32];

            snprintf(what, sizeof what, "%s axis", list);
            return dem_error_prefix(dem_unknown_word(what, axis[k], known, 3), "%s: ", dem_dict_where(dict));
        }
        DEM_REQUIRE(isfinite(d->max[a] - d->min[a]), DEM_ERROR_INPUT,
                    "%s: domain: axis %s is %s but has no limits; give them, %s (min max)", dem_dict_where(dict), axis[k], list, axis[k]);
        found[a] = 1;
    }
    return DEM_OK;
}

static int read_kinds(struct dem_domain *d, const struct dem_dict *dict)
{
    DEM_TRY(read_axes(d, dict, "periodic", d->periodic));
    DEM_TRY(read_axes(d, dict, "flat", d->flat));
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(!d->periodic[k] || !d->flat[k], DEM_ERROR_INPUT,
                    "%s: domain: axis %c is periodic and flat, but who stays in a plane goes round nothing; keep one", dem_dict_where(dict),
                    "xyz"[k]);
    }
    DEM_REQUIRE(d->flat[0] + d->flat[1] + d->flat[2] < 3, DEM_ERROR_INPUT, "%s: domain: all axes are flat, so that nothing moves; keep two at most",
                dem_dict_where(dict));
    dem_domain_close(d);
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
    DEM_TRY(read_limits(d, dict));
    DEM_TRY(dem_dict_word_or(dict, "leaving", "error", &leaving));
    d->remove = strcmp(leaving, "remove") == 0;
    if (!d->remove && strcmp(leaving, "error") != 0)
    {
        return dem_error_prefix(dem_unknown_word("way of leaving", leaving, known, 2), "%s: ", dem_dict_where(dict));
    }
    return read_kinds(d, dict);
}

/* What only some effects ask for; where none does, the entry is one that nobody reads. */
static int read_fluid_besides(struct dem_uniform_fluid *f, const struct dem_dict *dict, unsigned asked)
{
    static const double zero[3] = {0.0, 0.0, 0.0};

    DEM_TRY(asked & DEM_NEEDS_ACCELERATION ? dem_dict_vector_or(dict, "acceleration", "m/s2", zero, f->acceleration) : DEM_OK);
    DEM_TRY(asked & DEM_NEEDS_VORTICITY ? dem_dict_vector_or(dict, "vorticity", "1/s", zero, f->vorticity) : DEM_OK);
    return asked & DEM_NEEDS_STRESS ? dem_dict_vector_or(dict, "viscousStress", "N/m3", zero, f->stress) : DEM_OK;
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
                "%s: fluid: density %g kg/m3, viscosity %g Pa s, voidFraction %g; all must be above 0, the last at most 1",
                dem_dict_where(dict), f->density, f->viscosity, f->void_fraction);
    DEM_TRY(read_fluid_besides(f, dict, dem_recipe_asks(r)));
    /* a fluid at rest under the scene's gravity carries its own weight */
    dem_recipe_vector(r, "gravity", "acceleration", hydrostatic);
    for (int k = 0; k < 3; k++)
    {
        hydrostatic[k] *= f->density;
    }
    return dem_dict_vector_or(dict, "pressureGradient", "Pa/m", hydrostatic, f->pressure_gradient);
}

static int read_time(struct dem_scene *s, const struct dem_dict *scene, struct dem_recipe *r)
{
    const struct dem_dict *dict;
    const char *step, *precision;

    s->most_overlap = 0.5;
    DEM_TRY(dem_dict_sub_if(scene, "time", &dict));
    if (!dict)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_number_or(dict, "maxOverlap", "1", s->most_overlap, &s->most_overlap));
    DEM_REQUIRE(s->most_overlap > 0.0, DEM_ERROR_INPUT, "%s: maxOverlap %g of a diameter; give a number above 0", dem_dict_where(dict),
                s->most_overlap);
    DEM_TRY(dem_dict_number_or(dict, "maxSpeed", "m/s", 0.0, &s->most_speed));
    DEM_REQUIRE(s->most_speed > 0.0 || !dem_dict_has(dict, "maxSpeed"), DEM_ERROR_INPUT,
                "%s: maxSpeed %g m/s; give a number above 0, or leave it out", dem_dict_where(dict), s->most_speed);
    DEM_TRY(dem_dict_switch_or(dict, "force", false, &s->force));
    DEM_TRY(dem_dict_word_or(dict, "precision", "double", &precision));
    r->mixed = strcmp(precision, "mixed") == 0;
    DEM_REQUIRE(r->mixed || strcmp(precision, "double") == 0, DEM_ERROR_INPUT, "%s: precision %s; give double or mixed", dem_dict_where(dict),
                precision);
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
    s->tuned_skins = 1;
    DEM_TRY(dem_dict_sub_if(scene, "neighbours", &dict));
    if (!dict)
    {
        return DEM_OK;
    }
    s->tuned_skins = !dem_dict_has(dict, "outerSkin") && !dem_dict_has(dict, "innerSkin");
    DEM_TRY(dem_dict_number_or(dict, "outerSkin", "1", s->outer_skin, &s->outer_skin));
    DEM_TRY(dem_dict_number_or(dict, "innerSkin", "1", s->inner_skin, &s->inner_skin));
    DEM_REQUIRE(s->inner_skin > 0.0 && s->outer_skin >= s->inner_skin && s->outer_skin <= 2.0, DEM_ERROR_INPUT,
                "%s: outerSkin %g, innerSkin %g (of a diameter); give 0 < innerSkin <= outerSkin <= 2", dem_dict_where(dict),
                s->outer_skin, s->inner_skin);
    return DEM_OK;
}

/* ---- the whole ----------------------------------------------------------------------------------------------- */

static int check_bonds(const int64_t *id, size_t n, const char *where)
{
    DEM_REQUIRE(n%2 == 0, DEM_ERROR_INPUT, "%s: bonds/pairs: %zu ids; give two for each bond", where, n);
    for (size_t k = 0; k < n; k += 2)
    {
        DEM_REQUIRE(id[k] >= 0 && id[k + 1] >= 0 && id[k] != id[k + 1], DEM_ERROR_INPUT,
                    "%s: bonds/pairs: %lld and %lld; give two different ids of particles, whole numbers from 0", where, (long long)id[k],
                    (long long)id[k + 1]);
    }
    return DEM_OK;
}

/* Read only where an effect makes bonds, so that anywhere else it is an entry nobody reads. */
static int read_bonds(struct dem_scene *s, const struct dem_dict *scene, const struct dem_recipe *r)
{
    const struct dem_dict *bonds = NULL;
    const int listed = dem_recipe_word(r, "bondLinear", "make", "listed");

    if (listed >= 0)
    {
        DEM_TRY(dem_dict_sub_if(scene, "bonds", &bonds));
    }
    DEM_REQUIRE(listed <= 0 || bonds, DEM_ERROR_INPUT, "effects/bondLinear makes listed bonds, and the scene lists none; add bonds { pairs "
                "(...); } with two ids for each");
    if (!bonds)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_int64s(bonds, "pairs", &s->bond_ids, &s->bond_id_count));
    return check_bonds(s->bond_ids, s->bond_id_count, dem_dict_where(bonds));
}

int dem_scene_read(struct dem_scene *s, const struct dem_dict *scene, struct dem_recipe *r, struct dem_walls *w,
                   struct dem_domain *d)
{
    const struct dem_dict *insert, *outlets, *start;

    DEM_TRY(dem_scene_read_recipe(scene, r));
    DEM_TRY(dem_scene_read_walls(scene, r, w));
    DEM_TRY(read_domain(d, scene));
    DEM_TRY(read_fluid(&s->fluid, scene, r));
    DEM_TRY(read_time(s, scene, r));
    DEM_TRY(read_neighbours(s, scene));
    DEM_TRY(dem_averages_read(scene, &s->average, &s->averages));
    DEM_TRY(read_bonds(s, scene, r));
    DEM_TRY(dem_dict_sub_if(scene, "start", &start));
    if (start)
    {
        DEM_TRY(dem_dict_text(start, "snapshot", &s->snapshot));
    }
    DEM_TRY(dem_dict_sub_if(scene, "insert", &insert));
    DEM_TRY(dem_dict_sub_if(scene, "outlets", &outlets));
    DEM_TRY(dem_streams_read(&s->streams, insert, outlets, r));
    DEM_TRY(insert ? dem_insert_read(&s->insertion, insert, r) : DEM_OK);
    DEM_REQUIRE(!start || s->insertion.n == 0, DEM_ERROR_INPUT, "%s: the scene has both start and insert; keep one, or of insert only what "
                "is of type stream", dem_dict_where(start));
    return DEM_OK;
}

void dem_scene_free(struct dem_scene *s)
{
    dem_memory_free(s->average);
    dem_insert_free(&s->insertion);
    dem_streams_free(&s->streams);
    dem_crowd_free(&s->crowd);
}
