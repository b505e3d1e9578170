/*
 * plan.h -- the plan of a run before it starts: physics, time step, cost.
 *
 * Numbers come from dem_numbers.h; nothing here knows how the core stores them. The simulation is
 * only read, and the text is the same on all ranks. Formulas of fluidisation are in
 * minimum_fluidisation.h, of the regime and the verdicts on effects in regime.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_query.h"
#include "dem_numbers.h"
#include "dem_plan.h"
#include "core/text.h"

struct dem_plan    /* data of the paragraphs */
{
    struct dem *d;
    struct dem_run_info run;
    struct dem_scene_numbers scene;
    struct dem_run_cost cost;    /* set by dem_plan */
};

/* the paragraphs */
void dem_plan_parcels(struct dem_text *, const struct dem_plan *);     /* plan_parcels.c */
void dem_plan_step(struct dem_text *, const struct dem_plan *);        /* plan_cost.c */
void dem_plan_cost(struct dem_text *, const struct dem_plan *);
void dem_plan_bed(struct dem_text *, const struct dem_plan *);         /* plan_fluid.c */
void dem_plan_fluid(struct dem_text *, const struct dem_plan *);
void dem_plan_regime(struct dem_text *, const struct dem_plan *);      /* regime.c */

/* Collective. Asks for the numbers of the scene. */
int dem_plan_begin(struct dem_plan *, struct dem *, const struct dem_run_info *);

/* m/s2: magnitude of gravity */
double dem_plan_gravity(const struct dem_plan *);

/* Fills in the fluid and the spheres, grains where the particles are parcels, with their mean
   properties; returns 0 if the scene has no fluid or no particles. */
int dem_plan_suspension(const struct dem_plan *, struct dem_suspension *);
