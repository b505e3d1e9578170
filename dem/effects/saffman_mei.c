/*
 * saffman_mei.c -- lift on a sphere that lags or leads a sheared fluid.
 *
 *   F = 1.615 rho d^2 sqrt(nu/|o|) J w x o,   w = u - v,   Re_p = d |w|/nu,   k = d |o|/(2 |w|)
 *   J = (1 - 0.3314 sqrt k) exp(-Re_p/10) + 0.3314 sqrt k   for Re_p <= 40,   0.0524 sqrt(k Re_p) above
 *
 *   w    slip; u fluid velocity, v the sphere's                    [m/s]
 *   o    vorticity of the fluid, curl u                            [1/s]
 *   rho, nu, d   density, kinematic viscosity, diameter            [kg/m3], [m2/s], [m]
 *
 * A sphere that lags behind the fluid goes where the fluid is faster: in u_x(y) with du/dy > 0 the vorticity is along -z, and
 * w x o of w along x is along y. Saffman's is J = 1, for a fast shear (|w| far below sqrt(|o| nu)) at small Re_p; J is Mei's fit to the
 * simulations of Dandy and Dwyer, for k from 0.005 to 0.4 and Re_p to 100. At rest and without shear it is zero: J goes with w and o in products.
 * At Re_p = 40 J steps down by (1 - 0.3314 sqrt k)/e^4, as published: 14 % of it at k = 0.1, 6 % at 0.4.
 *
 * The fluid gets the opposite. The force is taken as constant within a kick; it does no work on the slip.
 *
 * Source: Saffman, J. Fluid Mech. 22 (1965) 385, with the corrigendum of 31 (1968) 624; Mei, Int. J. Multiphase Flow 18 (1992) 145.
 * Not here: walls; lift of bubbles, which the shape turns round; spin (see magnus).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "effects/slip.h"

DEM_KERNEL
static void act_on_bodies(const void *of, struct dem_body_block *restrict b)
{
    (void)of;
    for (int c = 0; c < b->n; c++)
    {
        const struct dem_slip w = dem_slip_of(b, c);
        const double o[3] = {b->ox[c], b->oy[c], b->oz[c]}, d = 2.0*b->radius[c];
        const double turns = sqrt(o[0]*o[0] + o[1]*o[1] + o[2]*o[2]);
        const double acts = dem_pick(turns*w.size > 1e-60, 1.0, 0.0);     /* the product of both is the force: below, none */
        const double k = acts*0.5*d*turns/dem_pick(acts > 0.0, w.size, 1.0);
        const double root = 0.3314*sqrt(k), fades = dem_exp(-0.1*w.re);
        const double J = dem_pick(w.re <= 40.0, (1.0 - root)*fades + root, 0.0524*sqrt(k*w.re));

        dem_slip_lift(b, c, &w, acts*1.615*b->density[c]*d*d*sqrt(w.nu/dem_pick(acts > 0.0, turns, 1.0))*J, o);
    }
}

const struct dem_effect dem_saffman_mei = {
    .name = "saffmanMei",
    .says = "lift on a sphere that lags a sheared fluid, towards where that is faster",
    .source = "Saffman 1965; Mei 1992",
    .stage = DEM_STAGE_FLUID,
    .reacts = 1,
    .needs = DEM_NEEDS_FLUID | DEM_NEEDS_VORTICITY,
    .act_on_bodies = act_on_bodies,
};
