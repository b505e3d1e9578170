/*
 * plan.c -- collect the data of a plan and write its paragraphs in order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/plan.h"
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

int dem_plan_write(struct dem_text *t, struct dem_plan *p)
{
    dem_inventory_take(p->state, &p->inventory);
    if (p->inventory.all.n > 0)
    {
        DEM_TRY(dem_step_cost_measure(p->state, &p->inventory, p->step, &p->step_cost));
    }
    dem_plan_effects(t, p);
    dem_plan_contacts(t, p);
    dem_plan_walls(t, p);
    dem_plan_particles(t, p);
    dem_plan_parcels(t, p);
    dem_plan_inflow(t, p);
    dem_plan_bed(t, p);
    dem_plan_fluid(t, p);
    DEM_TRY(dem_plan_regime(t, p));
    dem_plan_step(t, p);
    dem_plan_cost(t, p);
    return t->status;
}
