/*
 * warnings.h -- list likely mistakes in the scene before the first step: one numbered list, each item
 * with the entry to change.
 *
 *   no contact law       walls, and no normal law acts between them and particles
 *   driven               driven particles and walls, between which there is no force
 *   gravity              absent, or along +y or +z
 *   no drag              a fluid, and no drag law
 *   density              below 50 kg/m3: kg/m3 meant, g/cm3 given?
 *   Biot number          above 0.1 (biot.c)
 *   stiffness            youngsModulus above 1e10 Pa and more than 1e6 steps ahead
 *   fluid step           of more than 1e4 DEM steps: with its time
 *   fluid step           in which a particle crosses more than half of run.resolution: at its own
 *                        speed, a stream's, or the speed that fluid and gravity give it in the step
 *   impact speed         particles, streams, a wall (along its normal) or a fluid with drag faster
 *                        than impactSpeed, where the overlap of such an impact is above 5 % of a
 *                        diameter; above 20 % also slower ones
 *
 * Largest overlap d of an impact at v, with the contact time t_c at impactSpeed v_0 and the exponent p
 * of the normal law (F ~ d^p):
 *
 *   d = v_0 t_c/c (v/v_0)^(2/(p + 1)),   c = 2.943 for p = 3/2 (Hertz), pi for p = 1
 *
 * so that the stiffness for an overlap of d_1 is (d/d_1)^(p + 1) times the present one.
 *
 * Source: Johnson, Contact Mechanics (1985), section 11.4.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_ADVISOR_WARNINGS_H
#define DEM_ADVISOR_WARNINGS_H

#include "advisor/plan.h"

/* Collective. `own`: n sentences of the program, first in the list. Nothing is added to the text
   when there is nothing to warn of. */
int dem_warnings_write(struct dem_text *, struct dem_plan *, int coupled, int n,
                       const char *const *own);

struct dem_impact    /* an impact at a speed, of the pair class in which it overlaps most */
{
    const struct dem_effect *law;        /* NULL: no normal law has a contact time */
    const struct dem_pair_class *pair;
    double impact_speed;                 /* m/s  setting */
    double stiffness;                    /* its setting `stiffness`; 0: from the materials */
    double overlap;                      /* 1  of the smaller diameter */
    double factor;                       /* 1  on the stiffness, for 5 % */
};

#define DEM_IMPACT_OVERLAP 0.1    /* 1  of a diameter: a larger one is reported during the run */

/* Normal impact at this speed [m/s]. */
void dem_impact_at(const struct dem_interaction_table *, double speed, struct dem_impact *);

/* 1 if it overlaps too much. Then *text gets the end of a sentence: overlap, and what to take. */
int dem_impact_describe(const struct dem_impact *, double speed, struct dem_text *text);

/* The sentence on an overlap [1] that was measured, while the fastest particle has this speed
   [m/s]. */
void dem_impact_describe_overlap(const struct dem_impact *, double overlap, double speed,
                                 struct dem_text *text);

#endif
