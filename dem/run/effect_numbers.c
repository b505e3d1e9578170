/*
 * effect_numbers.c -- what the descriptors of effects say about a scene: relevance, sentences of
 * the plan, drag.
 *
 * The drag law of the scene is evaluated through a body batch, so no drag formula is repeated here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/effect_numbers.h"
#include "case/simulation.h"
#include "dem_numbers.h"
#include "laws/effects.h"
#include "laws/fluid/drag.h"
#include <string.h>

enum
{
    ROWS = 8    /* of a batch, all the same: it is padded to whole SIMD vectors */
};

/* Effect k of the list, NULL behind the last. */
static const struct dem_effect *effect_of(int k)
{
    const struct dem_effect *const *e = dem_effects;

    while (*e && k > 0)
    {
        e++;
        k--;
    }
    return k < 0 ? NULL : *e;
}

static const void *settings_in(const struct dem_effect_list *list, const struct dem_effect *effect)
{
    for (int k = 0; k < list->entries; k++)
    {
        if (list->entry[k].effect == effect)
        {
            return list->entry[k].settings;
        }
    }
    return NULL;
}

const void *dem_effect_settings(const struct dem_interaction_table *r,
                                const struct dem_effect *effect)
{
    if (effect->stage >= DEM_STAGE_BODY)
    {
        return settings_in(&r->bodies, effect);
    }
    return r->classes > 0 ? settings_in(&r->list[0], effect) : NULL;
}

/* The effect in use that another one of its kind would replace; NULL: none, or both may be used. */
static const char *replaced_by(const struct dem_interaction_table *r,
                               const struct dem_effect *effect)
{
    for (int k = 0; k < r->chosen; k++)
    {
        if (r->effect[k]->stage == effect->stage &&
            (effect->stage == DEM_STAGE_NORMAL || effect->stage == DEM_STAGE_DAMP))
        {
            return r->effect[k]->name;
        }
    }
    return NULL;
}

int dem_effect_info(const struct dem *d, int k, struct dem_effect_info *info)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;
    const struct dem_effect *const e = effect_of(k);

    if (!e)
    {
        return 0;
    }
    *info = (struct dem_effect_info){.name = e->name,
                                     .source = e->source,
                                     .drag = e->drag,
                                     .mechanism = e->mechanism,
                                     .in_use = dem_interaction_table_has_effect(r, e->name),
                                     .excluded = dem_interaction_table_excludes(r, e),
                                     .replaces = replaced_by(r, e)};
    return 1;
}

int dem_effect_relevance(const struct dem *d, int k, const struct dem_regime *g,
                         struct dem_relevance *v)
{
    const struct dem_effect *const e = effect_of(k);

    *v = (struct dem_relevance){.threshold = 0.01};
    return e && e->relevance
        && e->relevance(dem_effect_settings(&d->state.interaction_table, e), g, v);
}

int dem_effect_line(const struct dem *d, int k, const struct dem_regime *g, char *line, size_t size)
{
    const struct dem_effect *const e = effect_of(k);
    const void *const settings =
        e && e->describe ? dem_effect_settings(&d->state.interaction_table, e) : NULL;

    return settings && e->describe(settings, g, line, size);
}

double dem_drag_coefficient(const struct dem *d, const struct dem_suspension *s,
                            double void_fraction, double slip)
{
    const struct dem_effect_list *const effects = &d->state.interaction_table.bodies;
    const double volume = 3.14159265358979323846/6.0*s->diameter*s->diameter*s->diameter;
    struct dem_body_batch batch;
    double coefficient = 0.0;

    memset(&batch, 0, sizeof batch);
    batch.n = ROWS;
    for (int c = 0; c < ROWS; c++)
    {
        batch.radius[c] = 0.5*s->diameter;
        batch.volume[c] = volume;
        batch.sphericity[c] = batch.crosswise[c] = batch.lengthwise[c] = 1.0;
        batch.mass[c] = s->density*volume;
        batch.ux[c] = slip;
        batch.void_fraction[c] = void_fraction;
        batch.density[c] = s->fluid_density;
        batch.viscosity[c] = s->viscosity;
    }
    for (int k = 0; k < effects->entries; k++)
    {
        if (effects->entry[k].effect->drag)
        {
            dem_effect_apply_to_bodies(effects->entry[k].effect, effects->entry[k].settings, &batch);
            coefficient = batch.drag[0];
        }
    }
    return coefficient;
}

double dem_single_sphere_drag(double reynolds)
{
    return dem_drag_single_sphere(reynolds);
}
