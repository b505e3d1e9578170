/*
 * drag.h -- normalisation, Reynolds number and factors shared by the drag laws.
 *
 *   f = b (u - v),   b = 3 pi mu d G(e, Re),   Re = e rho d |u - v|/mu
 *
 *   G    1 for a single sphere in creeping flow; a drag law is a function G        [1]
 *   e    void fraction, limited to 0.2 .. 1                                        [1]
 *   Re   superficial Reynolds number                                               [1]
 *   u    interstitial fluid velocity; v particle velocity                          [m/s]
 *   mu, rho, d   viscosity and density of the fluid, diameter             [Pa s], [kg/m3], [m]
 *
 * The slip u - v is interstitial. Laws published for the superficial slip U = e (u - v) have their
 * drag coefficient multiplied by e here, and Re contains U. f is the drag in the form of the
 * averaged equations with shared pressure (model A, set II), where the pressure gradient is a force
 * of its own; a law published for the whole force (drag and pressure gradient, model B) has been
 * multiplied by e. All of G is written as products with Re, never quotients: at rest nothing is
 * 0/0.
 *
 * Source: Gidaspow, Multiphase Flow and Fluidization (1994), chapter 2; Zhou, Kuang, Chu, Yu, J.
 * Fluid Mech. 661 (2010) 482 for the forms of the equations.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/row.h"

/* e, limited to 0.2 .. 1: values outside result from smoothing and round-off */
DEM_MATH double dem_drag_void_fraction(double void_fraction)
{
    const double e = dem_select(void_fraction < 0.2, 0.2, void_fraction);

    return dem_select(e > 1.0, 1.0, e);
}

/* Re of a row, 0 where the viscosity is 0; e: void fraction, 1: Re of a single sphere */
DEM_MATH double dem_drag_reynolds(const struct dem_body_row *r, double e)
{
    const double x = r->ux - r->vx, y = r->uy - r->vy, z = r->uz - r->vz;
    const double slip = sqrt(x*x + y*y + z*z);
    const double mu = r->viscosity;

    return dem_select(mu > 0.0,
                      e*r->density*(2.0*r->radius)*slip/dem_select(mu > 0.0, mu, 1.0), 0.0);
}

/* Drag of a row by its G: coefficient and target. */
DEM_MATH void dem_drag_add(struct dem_body_row *r, double G)
{
    const double drag = 9.42477796076937971*r->viscosity*(2.0*r->radius)*G;    /* 3 pi mu d G */

    r->drag += drag;
    r->drag_ux += drag*r->ux;
    r->drag_uy += drag*r->uy;
    r->drag_uz += drag*r->uz;
}

/* Schiller and Naumann (1933) below 1000, constant Cd = 0.44 above; a step of +0.4 % there, as
   published */
DEM_MATH double dem_drag_single_sphere(double re)
{
    return dem_select(re < 1000.0, 1.0 + 0.15*dem_pow(re, 0.687), 0.44/24.0*re);
}

/* Voidage factor: Wen and Yu, Chem. Eng. Prog. Symp. Ser. 62 (1966) 100 */
DEM_MATH double dem_drag_voidage_factor(double e)
{
    return dem_pow(e, -2.65);
}

/* Ergun, Chem. Eng. Prog. 48 (1952) 89 */
DEM_MATH double dem_drag_ergun(double e, double re)
{
    return (150.0*(1.0 - e) + 1.75*re)/(18.0*e);
}

/* Cd Re/24 of a single sphere, Cd = (0.63 + 4.8/sqrt Re)^2: Dallavalle, Micromeritics (1948).
   0.96 at Re = 0, not 1 */
DEM_MATH double dem_drag_dallavalle(double re)
{
    const double root = 0.63*sqrt(re) + 4.8;

    return root*root/24.0;
}

/* exp(-(1.5 - log10 Re)^2/2): transition between creeping and inertial flow, 1 at Re = 32, 0 far
   from it */
DEM_MATH double dem_drag_transition(double re)
{
    const double from = 1.5 - dem_log10(dem_select(re > 1e-12, re, 1e-12));    /* e^-91 at 1e-12 */

    return dem_exp(-0.5*from*from);
}
