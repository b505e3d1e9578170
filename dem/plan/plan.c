/*
 * plan.c -- the order of the paragraphs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "plan/plan.h"
#include <math.h>

int dem_plan_kind(const struct dem_plan *p, struct dem_bed *b)
{
    const struct dem_stock *const all = &p->survey.all;
    const struct dem_uniform_fluid *const given = &p->scene->fluid;
    double g[3];

    if (all->n == 0)
    {
        return 0;
    }
    dem_recipe_vector(&p->parts->recipe, "gravity", "acceleration", g);
    *b = (struct dem_bed){.diameter = all->volume/(3.14159265358979323846/6.0*all->squares), .density = all->mass/all->volume,
                          .fluid_density = given->given ? given->density : p->survey.fluid_density,
                          .viscosity = given->given ? given->viscosity : p->survey.fluid_viscosity,
                          .gravity = sqrt(g[0]*g[0] + g[1]*g[1] + g[2]*g[2]),
                          .feels_gradient = dem_recipe_acts(&p->parts->recipe, "pressureGradient")};
    return b->fluid_density > 0.0 && b->viscosity > 0.0;
}

int dem_plan_write(struct dem_text *t, struct dem_plan *p)
{
    dem_survey_take(p->parts, &p->survey);
    if (p->survey.all.n > 0)
    {
        DEM_TRY(dem_pace_take(p->parts, &p->survey, p->step, &p->pace));
    }
    dem_plan_effects(t, p);
    dem_plan_contacts(t, p);
    dem_plan_walls(t, p);
    dem_plan_particles(t, p);
    dem_plan_flows(t, p);
    dem_plan_bed(t, p);
    dem_plan_fluid(t, p);
    DEM_TRY(dem_plan_regime(t, p));
    dem_plan_step(t, p);
    dem_plan_cost(t, p);
    return t->status;
}
