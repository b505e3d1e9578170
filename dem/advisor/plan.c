/*
 * plan.c -- write the paragraphs of a plan in order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/plan.h"
#include "core/error.h"

int dem_plan_write(struct dem_text *t, struct dem_plan *p)
{
    const char *scene;

    DEM_TRY(dem_scene_text(p->d, &scene));
    dem_text_add(t, "%s", scene);
    if (p->scene.particles > 0.0)
    {
        DEM_TRY(dem_run_cost(p->d, &p->cost));
    }
    dem_plan_parcels(t, p);
    dem_plan_bed(t, p);
    dem_plan_fluid(t, p);
    DEM_TRY(dem_plan_regime(t, p));
    dem_plan_step(t, p);
    dem_plan_cost(t, p);
    return t->status;
}
