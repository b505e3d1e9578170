/*
 * plan.h -- a run told before it runs: what acts, on what, with which step, and what it will take.
 *
 * Reads only; the same text on all ranks. Formulas of fluidisation are in fluidise.h, bytes and time in cost.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_PLAN_PLAN_H
#define DEM_PLAN_PLAN_H

#include "dem.h"
#include "io/scene.h"
#include "plan/cost.h"
#include "plan/fluidise.h"
#include "plan/text.h"
#include "step/parts.h"
#include "step/survey.h"

enum
{
    DEM_MOST_VERDICTS = 24
};

struct dem_verdicts
{
    struct dem_verdict verdict[DEM_MOST_VERDICTS];
    int n;
};

struct dem_plan                                           /* all that the paragraphs are made from */
{
    const struct dem_parts *parts;
    const struct dem_scene *scene;
    struct dem_prospect prospect;
    double step;                                          /* s, the limit in force */
    struct dem_survey survey;
    struct dem_pace pace;
    struct dem_verdicts verdicts;                         /* derived by dem_plan_regime */
};

/* Collective. Fill in survey and pace, write everything. */
int dem_plan_write(struct dem_text *, struct dem_plan *);

/* the paragraphs */
void dem_plan_effects(struct dem_text *, const struct dem_plan *);     /* what.c */
void dem_plan_contacts(struct dem_text *, const struct dem_plan *);
void dem_plan_walls(struct dem_text *, const struct dem_plan *);
void dem_plan_particles(struct dem_text *, const struct dem_plan *);
void dem_plan_flows(struct dem_text *, const struct dem_plan *);       /* through.c */
void dem_plan_step(struct dem_text *, const struct dem_plan *);        /* how.c */
void dem_plan_fluid(struct dem_text *, const struct dem_plan *);
int dem_plan_regime(struct dem_text *, struct dem_plan *);             /* regime.c; collective */
void dem_plan_bed(struct dem_text *, const struct dem_plan *);
void dem_plan_cost(struct dem_text *, const struct dem_plan *);

/* m: of the room along an axis, 0 to 2, between planes or of a periodic domain; 0 unknown. */
double dem_plan_width(const struct dem_plan *, int axis);

/* The fluid that particles feel, and the spheres as one kind; 0 when the scene has no fluid or no particles. */
int dem_plan_kind(const struct dem_plan *, struct dem_bed *);

#endif
