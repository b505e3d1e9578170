/*
 * saffman_mei.c -- Saffman lift: lift on a sphere with slip in a shear flow, with Mei's correction.
 *
 *   F = 1.615 rho d^2 sqrt(nu/|o|) J w x o,   w = u - v,   Re_p = d |w|/nu,   k = d |o|/(2 |w|)
 *   J = (1 - 0.3314 sqrt k) exp(-Re_p/10) + 0.3314 sqrt k   for Re_p <= 40
 *       0.0524 sqrt(k Re_p)                                 above
 *
 *   w    slip; u fluid velocity, v velocity of the sphere          [m/s]
 *   o    vorticity of the fluid, curl u                            [1/s]
 *   rho, nu, d   density, kinematic viscosity, diameter            [kg/m3], [m2/s], [m]
 *
 * Sign: a sphere that lags behind the fluid is lifted to where the fluid is faster: in u_x(y) with
 * du/dy > 0 the vorticity is along -z, and w x o of w along x is along y. J = 1 is the result of
 * Saffman, for strong shear (|w| much smaller than sqrt(|o| nu)) and small Re_p; J is the fit of
 * Mei to the simulations of Dandy and Dwyer, for k from 0.005 to 0.4 and Re_p to 100. At rest and
 * without shear the force is zero. At Re_p = 40 J has a step of -(1 - 0.3314 sqrt k)/e^4, as
 * published: 14 % of J at k = 0.1, 6 % at 0.4.
 *
 * The opposite force acts on the fluid. The force is constant within a kick; it does no work on the
 * slip.
 *
 * Source: Saffman, J. Fluid Mech. 22 (1965) 385, with the corrigendum of 31 (1968) 624; Mei, Int.
 * J. Multiphase Flow 18 (1992) 145.
 * Not here: walls; lift of bubbles, which their shape reverses; spin (see magnus).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/saffman_mei.h"

#define LAW dem_saffman_mei
#define SETS DEM_SETS_REACTION
#include "laws/body_loop.h"

/* Lift over drag, 1.615 d sqrt(o/nu) J/(3 pi f), f the drag over Stokes drag. Not known without
   slip, or in a coupled fluid without shear. */
static int relevance(const void *of, const struct dem_regime *g, struct dem_relevance *v)
{
    const double pi = 3.14159265358979324, d = g->suspension.diameter,
                 nu = g->suspension.viscosity/g->suspension.fluid_density;
    const int known = g->slip > 0.0 && (g->uniform || g->vorticity > 0.0);

    (void)of;
    v->fraction = known && g->vorticity > 0.0
                      ? 1.615*d*sqrt(g->vorticity/nu)*
                            dem_saffman_mei_correction(0.5*d*g->vorticity/g->slip, g->reynolds)/
                            (3.0*pi*g->drag_factor)
                      : 0.0;
    v->quantity = "of the drag is shear lift (Saffman 1965; Mei 1992)";
    return known;
}

const struct dem_effect dem_saffman_mei = {
    .name = "saffmanMei",
    .summary = "Saffman lift: on a sphere that lags behind a shear flow, towards faster fluid",
    .source = "Saffman 1965; Mei 1992",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_GRAINS,
    .has_reaction = 1,
    .needs = DEM_NEEDS_FLUID | DEM_NEEDS_VORTICITY,
    .apply_to_bodies = apply_to_bodies,
    .relevance = relevance,
    .mechanism = DEM_MECHANISM_LIFT,
};
