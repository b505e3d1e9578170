/*
 * drag.h -- what drag laws share: one normalisation, the Reynolds number, the single sphere and Wen and Yu's swarm.
 *
 *   f = b (u - v),   b = 3 pi mu d G(e, Re),   Re = e rho d |u - v|/mu
 *
 *   G    1 for a single sphere creeping through the fluid; a law of drag is a G    [1]
 *   e    void fraction, taken from 0.2 to 1                                        [1]
 *   Re   superficial Reynolds number                                               [1]
 *   u    fluid velocity between the grains; v particle velocity                    [m/s]
 *   mu, rho, d   viscosity, density of the fluid, diameter                         [Pa s], [kg/m3], [m]
 *
 * The slip is that of the fluid between the grains (interstitial), u - v. Papers that write the superficial slip
 * U = e (u - v) have their drag coefficient multiplied by e here, and Re holds U. f is the drag of the pressure-shared
 * form of the averaged equations (model A, set II), where the pressure gradient is a force of its own; a law given for
 * the whole force (drag and pressure gradient, model B) has been multiplied by e. All of G is products with Re, never a
 * quotient by it: at rest nothing is 0/0.
 *
 * Source: Gidaspow, Multiphase Flow and Fluidization (1994), chapter 2; Zhou, Kuang, Chu, Yu, J. Fluid Mech. 661 (2010)
 * 482 for the forms of the equations.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_DRAG_H
#define DEM_EFFECTS_DRAG_H

#include "base/math.h"
#include "effects/block.h"

/* e; below 0.2 no packing exists, above 1 no fluid: both come from smoothing and round-off */
static inline __attribute__((always_inline)) double dem_drag_void(double void_fraction)
{
    const double e = dem_pick(void_fraction < 0.2, 0.2, void_fraction);

    return dem_pick(e > 1.0, 1.0, e);
}

/* Re; 0 where there is no viscosity, for there is no law then */
static inline __attribute__((always_inline)) double dem_drag_reynolds(const struct dem_body_block *b, int c, double e)
{
    const double x = b->ux[c] - b->vx[c], y = b->uy[c] - b->vy[c], z = b->uz[c] - b->vz[c];
    const double slip = sqrt(x*x + y*y + z*z);
    const double mu = b->viscosity[c];

    return dem_pick(mu > 0.0, e*b->density[c]*(2.0*b->radius[c])*slip/dem_pick(mu > 0.0, mu, 1.0), 0.0);
}

/* Schiller and Naumann (1933) below 1000, Newton's Cd = 0.44 above; as published it steps up there by 0.4 % */
static inline __attribute__((always_inline)) double dem_drag_single_sphere(double re)
{
    return dem_pick(re < 1000.0, 1.0 + 0.15*dem_pow(re, 0.687), 0.44/24.0*re);
}

/* How much a swarm raises it: Wen and Yu, Chem. Eng. Prog. Symp. Ser. 62 (1966) 100 */
static inline __attribute__((always_inline)) double dem_drag_swarm(double e)
{
    return dem_pow(e, -2.65);
}

/* Ergun, Chem. Eng. Prog. 48 (1952) 89 */
static inline __attribute__((always_inline)) double dem_drag_ergun(double e, double re)
{
    return (150.0*(1.0 - e) + 1.75*re)/(18.0*e);
}

/* Cd Re/24 of a lone sphere, Cd = (0.63 + 4.8/sqrt Re)^2: Dallavalle, Micromeritics (1948). 0.96 at Re = 0, not 1 */
static inline __attribute__((always_inline)) double dem_drag_dallavalle(double re)
{
    const double root = 0.63*sqrt(re) + 4.8;

    return root*root/24.0;
}

/* exp(-(1.5 - log10 Re)^2/2): how far a swarm is between creeping and inertial flow, 1 at Re = 32 and 0 far from it */
static inline __attribute__((always_inline)) double dem_drag_bell(double re)
{
    const double from = 1.5 - dem_log10(dem_pick(re > 1e-12, re, 1e-12));    /* e^-91 at 1e-12 */

    return dem_exp(-0.5*from*from);
}

/* add the drag of row c */
static inline __attribute__((always_inline)) void dem_drag_add(struct dem_body_block *b, int c, double g)
{
    const double coefficient = 9.42477796076937971*b->viscosity[c]*(2.0*b->radius[c])*g;    /* 3 pi mu d G */

    b->b[c] += coefficient;
    b->bux[c] += coefficient*b->ux[c];
    b->buy[c] += coefficient*b->uy[c];
    b->buz[c] += coefficient*b->uz[c];
}

#endif
