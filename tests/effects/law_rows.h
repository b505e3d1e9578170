/*
 * law_rows.h -- contact rows filled by hand: two spheres, or a sphere and a plane, and the laws
 * between them.
 *
 *   struct law_rows w;
 *   rows_spheres(&w, &glass, &glass, 0.01, 0.01);    or rows_wall(&w, &glass, &glass, 0.01)
 *   struct rows_effect *l = rows_add(&w, &dem_hertz, "impactSpeed", 1.0);
 *   w.b.n = 1; w.b.overlap[0] = 1e-6; ...               the rows
 *   l->effect->apply(l->settings, &w.b, l->history);
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/effects.h"
#include "laws/interaction_table.h"
#include "unit/tap.h"

#include <stdlib.h>
#include <string.h>

enum
{
    ROWS_EFFECTS = 4,
    ROWS_HISTORY = 4
};

struct rows_effect
{
    const struct dem_effect *effect;
    /* large enough for any settings struct, aligned */
    double settings[32];
    _Alignas(64) double column[ROWS_HISTORY][DEM_BATCH_ROWS];
    double *history[ROWS_HISTORY];
};

struct law_rows
{
    struct dem_pair_class pair;
    /* the wall: radius 0, mass 0 for infinite */
    double radius[2], mass[2];
    int effects;
    struct rows_effect effect_entry[ROWS_EFFECTS];
    struct dem_contact_batch b;
};

static inline struct dem_material material(const char *name, double E, double nu, double rho)
{
    struct dem_material m = {.density = rho, .youngs_modulus = E, .poissons_ratio = nu};

    snprintf(m.name, sizeof m.name, "%s", name);
    return m;
}

static inline double sphere_mass(double radius, double density)
{
    return 4.0/3.0*3.14159265358979324*radius*radius*radius*density;
}

/* E* and G* of the class; a rigid wall has an infinite modulus and adds nothing */
static inline void rows_class(struct law_rows *w, const struct dem_material *a,
                                 const struct dem_material *b, int wall)
{
    double e = 0.0, g = 0.0;
    const struct dem_material *const both[2] = {a, b};

    for (int k = 0; k < 2; k++)
    {
        const double nu = both[k]->poissons_ratio, E = both[k]->youngs_modulus;

        e += isfinite(E) ? (1.0 - nu*nu)/E : 0.0;
        g += isfinite(E) ? 2.0*(2.0 - nu)*(1.0 + nu)/E : 0.0;
    }
    w->pair = (struct dem_pair_class){.a = a, .b = b, .with_wall = wall, .reduced_modulus = 1.0/e,
                                      .reduced_shear = 1.0/g, .exponent = 1.0};
}

static inline void rows_spheres(struct law_rows *w, const struct dem_material *a,
                                   const struct dem_material *b, double radius_a, double radius_b)
{
    memset(w, 0, sizeof *w);
    rows_class(w, a, b, 0);
    w->radius[0] = radius_a;
    w->radius[1] = radius_b;
    w->mass[0] = sphere_mass(radius_a, a->density);
    w->mass[1] = sphere_mass(radius_b, b->density);
    w->pair.min_radius = radius_a*radius_b/(radius_a + radius_b);
    w->pair.min_mass = w->mass[0]*w->mass[1]/(w->mass[0] + w->mass[1]);
}

static inline void rows_wall(struct law_rows *w, const struct dem_material *a,
                                const struct dem_material *b, double radius)
{
    memset(w, 0, sizeof *w);
    rows_class(w, a, b, 1);
    w->radius[0] = radius;
    w->mass[0] = sphere_mass(radius, a->density);
    w->pair.min_radius = radius;
    w->pair.min_mass = w->mass[0];
}

/* 4/3 E* sqrt(R*): F = this d^1.5 */
static inline double rows_hertz(const struct law_rows *w)
{
    return 4.0/3.0*w->pair.reduced_modulus*sqrt(w->pair.min_radius);
}

/* set one number or choice (by its index), check that all required settings are given, prepare; 0
   or the status */
static inline int apply_setting(const struct dem_effect *effect, void *settings,
                         const struct dem_pair_class *pair, const char *name, double value)
{
    const struct dem_setting *const f = dem_settings_find(effect->settings, name);

    if (f && (f->kind == DEM_SETTING_CHOICE || f->kind == DEM_SETTING_SWITCH))
    {
        const int choice = (int)value;

        memcpy((char *)settings + f->offset, &choice, sizeof choice);
    }
    else
    {
        DEM_TRY(dem_settings_set_number(effect->settings, settings, effect->name, name, &value, 1));
    }
    DEM_TRY(dem_settings_check_complete(effect->settings, settings, effect->name));
    return effect->prepare ? effect->prepare(settings, pair) : DEM_OK;
}

/* append an effect with one setting; more by apply_setting(w.effect_entry[k].effect,
   w.effect_entry[k].settings, &w.pair, ...) */
static inline struct rows_effect *rows_add(struct law_rows *w, const struct dem_effect *effect,
                                                 const char *name, double value)
{
    struct rows_effect *const l = &w->effect_entry[w->effects++];

    l->effect = effect;
    for (int k = 0; k < ROWS_HISTORY; k++)
    {
        l->history[k] = l->column[k];
    }
    if (effect->stage == DEM_STAGE_NORMAL)
    {
        w->pair.exponent = effect->exponent;
    }
    if (effect->size > sizeof l->settings)
    {
        printf("Bail out! settings of %s are larger than the test's buffer\n", effect->name);
        exit(1);
    }
    dem_settings_set_defaults(effect->settings, l->settings);
    if (apply_setting(effect, l->settings, &w->pair, name, value))
    {
        printf("Bail out! %s\n", dem_error_text());
        exit(1);
    }
    return l;
}
