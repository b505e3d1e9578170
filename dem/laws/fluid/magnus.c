/*
 * magnus.c -- Magnus lift: lift on a spinning sphere.
 *
 *   F = pi/8 rho d^3 C w x W,   w = u - v,   Re_p = d |w|/nu,   S = d |W|/|w|
 *   C = 1 - (0.675 + 0.15 (1 + tanh(0.28 (S - 2)))) tanh(0.18 sqrt Re_p)
 *
 *   w    slip; u fluid velocity, v velocity of the sphere          [m/s]
 *   W    spin of the sphere                                        [1/s]
 *   rho, nu, d   density, kinematic viscosity, diameter            [kg/m3], [m2/s], [m]
 *
 * C = 1 is pi R^3 rho W x v of Rubinow and Keller for small Re_p. Sign: a sphere that moves along x
 * with topspin (W along y, z up) is pressed down: w is along -x, and -x cross y is -z. Loth and
 * Dorgan add this lift to the shear lift on a sphere without spin (saffmanMei), so W is the whole
 * spin. Use it together with viscousTorque: without a torque the spin never decays.
 *
 * The opposite force acts on the fluid. The force is constant within a kick; it does no work on the
 * slip.
 *
 * Source: Rubinow, Keller, J. Fluid Mech. 11 (1961) 447; Loth, Dorgan, Environ. Fluid Mech. 9
 * (2009) 187, for Re_p to 2000, S to 20.
 * Not here: walls; the additional drag by spin; the reversed lift of smooth spheres at Re_p of 1e5.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/magnus.h"

#define LAW dem_magnus
#define SETS DEM_SETS_REACTION
#include "laws/body_loop.h"

/* Lift over drag, rho d^2 C W/(24 mu f), f the drag over Stokes drag, times the fraction of a
   response time that fits between two collisions, which change the spin; W = 10/7 v/d of a sphere
   that slid on another until it rolled. Not known without friction or in an open domain. */
static int relevance(const void *of, const struct dem_regime *g, struct dem_relevance *v)
{
    const double d = g->suspension.diameter, spin = 10.0/7.0*g->collision_speed/d;
    const int known = g->friction > 0.0 && g->collision_time > 0.0 && g->slip > 0.0;

    (void)of;
    if (known)
    {
        const double C = dem_magnus_coefficient(d*spin/g->slip, g->reynolds),
                     lasts = fmin(1.0, g->collision_time/g->response);

        v->fraction = lasts*g->suspension.fluid_density*d*d*C*spin/
                      (24.0*g->suspension.viscosity*g->drag_factor);
    }
    v->quantity =
        "of the drag is lift by the spin after a collision, while it lasts (Rubinow and Keller 1961; Loth and Dorgan 2009)";
    return known;
}

const struct dem_effect dem_magnus = {
    .name = "magnus",
    .summary = "Magnus lift: on a spinning sphere, normal to its spin and its slip",
    .source = "Rubinow and Keller 1961; Loth and Dorgan 2009",
    .stage = DEM_STAGE_FLUID,
    .has_reaction = 1,
    .needs = DEM_NEEDS_FLUID | DEM_NEEDS_SPIN,
    .apply_to_bodies = apply_to_bodies,
    .relevance = relevance,
    .mechanism = DEM_MECHANISM_LIFT,
};
