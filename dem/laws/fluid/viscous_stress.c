/*
 * viscous_stress.c -- force of the viscous stress of the mean flow on a particle.
 *
 *   F = V div tau
 *
 *   V     volume of the particle                                   [m3]
 *   tau   viscous and turbulent stress of the fluid                [Pa]
 *
 * It complements the pressure gradient: with both, a particle experiences the force that would act
 * on the fluid it displaces, and the fraction e of each is left to the fluid. The opposite force
 * acts on the fluid, so with this effect the fluid equation has the whole div tau, of which e div
 * tau is left, and without it div(e tau).
 *
 * Source: Zhou, Kuang, Chu, Yu, J. Fluid Mech. 661 (2010) 482, sets I and II.
 * Not here: the additional stress of the suspension (Einstein viscosity).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/viscous_stress.h"

#define LAW dem_viscous_stress
#define SETS DEM_SETS_REACTION
#include "laws/body_loop.h"

/* div tau over drag, V |div tau|/(3 pi mu d f u), or over the weight at rest; in coupled runs div
   tau is estimated as mu o over a cell size. Not known in a coupled fluid without shear. */
static int relevance(const void *of, const struct dem_regime *g, struct dem_relevance *v)
{
    const double pi = 3.14159265358979324, d = g->suspension.diameter;
    const int known = g->uniform || (g->vorticity > 0.0 && g->cell > 0.0);
    const double stress = g->uniform ? g->stress
                          : known ? g->suspension.viscosity*g->vorticity/g->cell
                                     : 0.0;
    const double drag = 3.0*pi*g->suspension.viscosity*d*g->drag_factor*g->slip,
                 against = drag > 0.0 ? drag : g->weight;

    (void)of;
    v->fraction = stress*pi/6.0*d*d*d/against;
    v->quantity = "of the drag is the viscous stress of the mean flow (Zhou, Kuang, Chu, Yu 2010)";
    return known && against > 0.0;
}

const struct dem_effect dem_viscous_stress = {
    .name = "viscousStress",
    .summary = "force of the viscous stress of the mean flow, V div tau",
    .source = "Zhou, Kuang, Chu, Yu 2010",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_SAME,
    .has_reaction = 1,
    .needs = DEM_NEEDS_FLUID | DEM_NEEDS_STRESS,
    .apply_to_bodies = apply_to_bodies,
    .relevance = relevance,
    .mechanism = DEM_MECHANISM_STRESS,
};
