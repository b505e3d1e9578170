/*
 * koch_hill.c -- drag of Hill, Koch and Ladd, from lattice-Boltzmann simulations of random arrays.
 *
 *   G = e^2 (F0 + F3 Re/2)
 *   F0 = (1 + 3 sqrt(s/2) + 135/64 s ln s + 16.14 s)/(1 + 0.681 s - 8.48 s^2 + 8.16 s^3)
 *        for s < 0.4, otherwise 10 s/e^3
 *   F3 = 0.0673 + 0.212 s + 0.0232/e^5
 *
 *   G    drag over Stokes drag, f = 3 pi mu d G (u - v)            [1]   see drag.h
 *   e    void fraction; s = 1 - e                                  [1]
 *   Re   superficial Reynolds number, e rho d |u - v|/mu           [1]
 *
 * G -> 1 for e -> 1, Re -> 0. F0 has a step of 1 % at s = 0.4, as published.
 *
 * Source: Hill, Koch, Ladd, J. Fluid Mech. 448 (2001) 213 and 243; Koch and Hill, Annu. Rev. Fluid
 * Mech. 33 (2001) 619. Changed: Re/2, because their Reynolds number is formed with the radius.
 * Not here: their other formula, quadratic in Re, for Re below 20; at Re -> 0 both are F0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"

#include "laws/fluid/drag.h"

/* F0; the denominator of the dilute form is positive for s = 0 to 0.8, with a minimum of 0.1 at
   0.65 */
DEM_MATH double creeping(double e, double s)
{
    const double logarithm = dem_log(dem_select(s > 0.0, s, 1.0));    /* s ln s is 0 at s = 0 */
    const double dilute = (1.0 + 3.0*sqrt(0.5*s) + 135.0/64.0*s*logarithm + 16.14*s)
                        / (1.0 + s*(0.681 + s*(8.16*s - 8.48)));

    return dem_select(s < 0.4, dilute, 10.0*s/(e*e*e));
}

/* F3 */
DEM_MATH double inertial(double e, double s)
{
    return 0.0673 + 0.212*s + 0.0232/(e*e*e*e*e);
}

/* F0, and half of F3 */
DEM_MATH void voidage_factors(const void *settings, double e, double *factor)
{
    const double s = 1.0 - e;

    (void)settings;
    factor[0] = creeping(e, s);
    factor[1] = 0.5*inertial(e, s);
}

DEM_MATH double drag_over_stokes(const struct dem_drag_row *r)
{
    return r->e*r->e*(r->factor[0] + r->factor[1]*r->re);
}

#define HAS_VOIDAGE_FACTORS
#include "laws/fluid/drag_loop.h"

const struct dem_effect dem_koch_hill = {
    .name = "kochHill",
    .aliases = "KochHill KochHillDrag HillKochLadd",
    .summary =
        "drag from packed to dilute, fitted to lattice-Boltzmann simulations of random arrays",
    .source = "Hill, Koch, Ladd 2001; Koch and Hill 2001",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_GRAINS,
    .drag = DEM_DRAG_BED,
    .needs = DEM_NEEDS_FLUID,
    .prepare_bodies = prepare_bodies,
    .apply_to_bodies = apply_to_bodies,
};
