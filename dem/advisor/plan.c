/*
 * plan.c -- what all paragraphs of a plan share: numbers of the scene, gravity, suspension.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/plan.h"
#include <math.h>

int dem_plan_begin(struct dem_plan *p, struct dem *d, const struct dem_run_info *run)
{
    *p = (struct dem_plan){.d = d, .run = *run};
    return dem_scene_numbers(d, &p->scene);
}

double dem_plan_gravity(const struct dem_plan *p)
{
    const double *const g = p->scene.gravity;

    return sqrt(g[0]*g[0] + g[1]*g[1] + g[2]*g[2]);
}

int dem_plan_suspension(const struct dem_plan *p, struct dem_suspension *b)
{
    const struct dem_scene_numbers *const s = &p->scene;

    if (s->particles == 0.0)
    {
        return 0;
    }
    *b = (struct dem_suspension){
        .diameter = s->volume/(3.14159265358979323846/6.0*s->grain_squares),
        .density = s->mass/s->volume,
        .fluid_density = s->fluid_density,
        .viscosity = s->viscosity,
        .gravity = dem_plan_gravity(p),
        .feels_gradient = s->pressure_gradient};
    return b->fluid_density > 0.0 && b->viscosity > 0.0;
}
