/*
 * regime.h -- the numbers that decide which effects a scene needs, and what they say of each: verdicts.
 *
 * Spheres of the Sauter diameter, and the first pair of materials, stand for all. Formulas with their sources: regime.c (numbers),
 * verdicts_fluid.c, verdicts_contact.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_PLAN_REGIME_H
#define DEM_PLAN_REGIME_H

#include "plan/plan.h"

struct dem_regime                                         /* 0: not known, where nothing else is said */
{
    int fluid;                                            /* 1: there is one */
    struct dem_bed bed;                                   /* of one kind of sphere */
    double phi;                                           /* 1    volume of particles over that of the room */
    double flow;                                          /* m/s  of the fluid; what moves it is not counted */
    double slip, reynolds, more;                          /* m/s, 1, 1: between sphere and fluid; drag over Stokes' */
    double response;                                      /* s    in which a sphere follows the fluid at that slip */
    double vorticity, stress;                             /* 1/s, N/m3 */
    double width;                                         /* m    narrowest of the room */
    double mass, radius, modulus;                         /* kg, m, Pa: m*, R*, E* */
    double speed, stokes;                                 /* m/s, 1: of an impact at the normal law's impactSpeed */
    double meets, between;                                /* m/s, s: two that meet in the fluid, and the time from one to the next */
    double overlap;                                       /* 1    of an elastic impact at `speed`, over R* */
    double friction;                                      /* 1    of sliding; 0 without a law */
    double weight;                                        /* N    of one sphere */
    double yields;                                        /* m/s  slowest impact that yields, where materials tell a yieldStrength */
};

/* Fill in what is known. */
void dem_regime_take(const struct dem_plan *, struct dem_regime *);

/* A number of an effect of contacts, between the first pair of materials; not a number where it does not act. */
double dem_regime_number(const struct dem_plan *, const char *effect, const char *entry);

/* Drag of a lone sphere over Stokes' at a Reynolds number. */
double dem_regime_drag(double reynolds);

/* One verdict more: of an effect that acts, or of one that does not and would do more than `limit`. The share is of what `why` tells;
   `why` ends in the source. Returns it where there is one to fill in further, else NULL. */
struct dem_verdict *dem_judge(struct dem_plan *, const char *effect, double share, double limit, const char *why);

void dem_judge_fluid(struct dem_plan *, const struct dem_regime *);
void dem_judge_contacts(struct dem_plan *, const struct dem_regime *);

/* Collective. What each negligible one of them costs: the block of cost.h with it and without. */
int dem_judge_costs(struct dem_plan *);

#endif
