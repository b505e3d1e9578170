/*
 * magnus.c -- lift on a sphere that spins.
 *
 *   F = pi/8 rho d^3 C w x W,   w = u - v,   Re_p = d |w|/nu,   S = d |W|/|w|
 *   C = 1 - (0.675 + 0.15 (1 + tanh(0.28 (S - 2)))) tanh(0.18 sqrt Re_p)
 *
 *   w    slip; u fluid velocity, v the sphere's                    [m/s]
 *   W    spin of the sphere                                        [1/s]
 *   rho, nu, d   density, kinematic viscosity, diameter            [kg/m3], [m2/s], [m]
 *
 * C = 1 is Rubinow and Keller's pi R^3 rho W x v of a slow sphere. A ball that flies along x and rolls forward on its way (W along y,
 * z up) is pressed down: w is along -x, and -x cross y is -z. Loth and Dorgan add this to the lift of shear on a sphere that does not
 * spin (saffmanMei), so W is the whole spin. Take viscousTorque with it: what nothing slows spins for ever.
 *
 * The fluid gets the opposite. The force is taken as constant within a kick; it does no work on the slip.
 *
 * Source: Rubinow, Keller, J. Fluid Mech. 11 (1961) 447; Loth, Dorgan, Environ. Fluid Mech. 9 (2009) 187, for Re_p to 2000, S to 20.
 * Not here: walls; the drag that spin adds; the reversed lift of smooth spheres at Re_p of 1e5.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "effects/slip.h"

/* 1 - 2/(e^2x + 1), odd; past 30 it is 1 to the last bit */
static inline __attribute__((always_inline)) double hyperbolic(double x)
{
    const double size = dem_pick(fabs(x) > 30.0, 30.0, fabs(x)), more = dem_expm1(2.0*size), y = more/(more + 2.0);

    return dem_pick(x < 0.0, -y, y);
}

DEM_KERNEL
static void act_on_bodies(const void *of, struct dem_body_block *restrict b)
{
    const double eighth_pi = 0.39269908169872415;

    (void)of;
    for (int c = 0; c < b->n; c++)
    {
        const struct dem_slip w = dem_slip_of(b, c);
        const double spin[3] = {b->wx[c], b->wy[c], b->wz[c]}, d = 2.0*b->radius[c];
        const double turns = sqrt(spin[0]*spin[0] + spin[1]*spin[1] + spin[2]*spin[2]);
        const double S = dem_pick(w.size > 1e-60, d*turns/dem_pick(w.size > 1e-60, w.size, 1.0), 0.0);
        const double C = 1.0 - (0.675 + 0.15*(1.0 + hyperbolic(0.28*(S - 2.0))))*hyperbolic(0.18*sqrt(w.re));

        dem_slip_lift(b, c, &w, eighth_pi*b->density[c]*d*d*d*C, spin);
    }
}

const struct dem_effect dem_magnus = {
    .name = "magnus",
    .says = "lift on a sphere that spins, across its spin and its slip",
    .source = "Rubinow and Keller 1961; Loth and Dorgan 2009",
    .stage = DEM_STAGE_FLUID,
    .reacts = 1,
    .needs = DEM_NEEDS_FLUID | DEM_NEEDS_SPIN,
    .act_on_bodies = act_on_bodies,
};
