/*
 * plan.h -- the plan of a run before it starts: physics, time step, cost.
 *
 * The simulation is only read, and the text is the same on all ranks. Formulas of fluidisation are
 * in minimum_fluidisation.h, memory and processor time in time_estimate.h, verdicts on effects in
 * regime.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_ADVISOR_PLAN_H
#define DEM_ADVISOR_PLAN_H

#include "dem_plan.h"
#include "case/scene.h"
#include "advisor/time_estimate.h"
#include "records/bed_packing.h"
#include "advisor/minimum_fluidisation.h"
#include "core/text.h"
#include "ranks/dem_state.h"
#include "records/inventory.h"

enum
{
    DEM_MAX_VERDICTS = 24
};

struct dem_verdicts
{
    struct dem_verdict verdict[DEM_MAX_VERDICTS];
    int n;
};

struct dem_plan                                           /* data of the paragraphs */
{
    const struct dem_state *state;
    const struct dem_scene *scene;
    struct dem_run_info run;
    double step;                                          /* s  time step in use */
    struct dem_inventory inventory;
    struct dem_step_cost step_cost;
    struct dem_verdicts verdicts;                         /* set by dem_plan_regime */
};

/* Collective. Fills in survey and pace, writes all paragraphs. Returns DEM_OK or an error. */
int dem_plan_write(struct dem_text *, struct dem_plan *);

/* the paragraphs */
void dem_plan_effects(struct dem_text *, const struct dem_plan *);     /* plan_physics.c */
void dem_plan_contacts(struct dem_text *, const struct dem_plan *);
void dem_plan_walls(struct dem_text *, const struct dem_plan *);
void dem_plan_particles(struct dem_text *, const struct dem_plan *);
void dem_plan_parcels(struct dem_text *, const struct dem_plan *);      /* plan_parcels.c */
void dem_plan_inflow(struct dem_text *, const struct dem_plan *);       /* plan_inflow.c */
void dem_plan_step(struct dem_text *, const struct dem_plan *);        /* plan_cost.c */
void dem_plan_fluid(struct dem_text *, const struct dem_plan *);
int dem_plan_regime(struct dem_text *, struct dem_plan *);             /* regime.c; collective */
void dem_plan_bed(struct dem_text *, const struct dem_plan *);
void dem_plan_cost(struct dem_text *, const struct dem_plan *);

/* m: width of the domain along an axis, 0 to 2, between planes or periodic boundaries; 0
   unknown. */
double dem_plan_width(const struct dem_plan *, int axis);

/* m: Sauter diameter of the particles. */
double dem_plan_sauter_diameter(const struct dem_plan *);

/* Fills in the fluid and the spheres, grains where the particles are parcels, with their mean
   properties; returns 0 if the scene has no
   fluid or no particles. */
int dem_plan_suspension(const struct dem_plan *, struct dem_suspension *);

#endif
