/*
 * plan.c -- collect the data of a plan and write its paragraphs in order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/plan.h"

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
