/*
 * plan_quantities.c -- what several paragraphs of a plan take from the scene: width, mean diameter,
 * suspension, settings of an effect.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/plan.h"
#include "advisor/regime.h"
#include <math.h>

double dem_plan_sauter_diameter(const struct dem_plan *p)
{
    return p->inventory.all.volume/(3.14159265358979323846/6.0*p->inventory.all.squares);
}

int dem_plan_suspension(const struct dem_plan *p, struct dem_suspension *b)
{
    const struct dem_material_inventory *const all = &p->inventory.all;
    const struct dem_uniform_fluid *const given = &p->scene->fluid;
    double g[3];

    if (all->n == 0)
    {
        return 0;
    }
    dem_interaction_table_gravity(&p->state->interaction_table, g);
    *b = (struct dem_suspension){
        .diameter = all->volume/(3.14159265358979323846/6.0*all->grain_squares),
        .density = all->mass/all->volume,
        .fluid_density = given->given ? given->density : p->inventory.fluid_density,
        .viscosity = given->given ? given->viscosity : p->inventory.fluid_viscosity,
        .gravity = sqrt(g[0]*g[0] + g[1]*g[1] + g[2]*g[2]),
        .feels_gradient = dem_interaction_table_has_pressure_gradient(
            &p->state->interaction_table)};
    return b->fluid_density > 0.0 && b->viscosity > 0.0;
}

double dem_plan_width(const struct dem_plan *p, int axis)
{
    const struct dem_state *const state = p->state;
    double low = -INFINITY, high = INFINITY;

    if (state->domain.periodic[axis])
    {
        return state->domain.length[axis];
    }
    for (int k = 0; k < state->walls.walls; k++)
    {
        const struct dem_wall *const w = &state->walls.wall[k];
        const double along = w->shape == DEM_SHAPE_PLANE ? w->normal[axis] : 0.0;

        low = along == 1.0 ? fmax(low, w->point[axis]) : low;
        high = along == -1.0 ? fmin(high, w->point[axis]) : high;
    }
    return isfinite(high - low) && high > low ? high - low : 0.0;
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

const void *dem_regime_settings(const struct dem_plan *p, const struct dem_effect *effect)
{
    const struct dem_interaction_table *const r = &p->state->interaction_table;

    if (effect->stage >= DEM_STAGE_BODY)
    {
        return settings_in(&r->bodies, effect);
    }
    return r->classes > 0 ? settings_in(&r->list[0], effect) : NULL;
}
