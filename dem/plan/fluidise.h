/*
 * fluidise.h -- when does a fluid carry a bed, and how fast does a sphere follow it: the numbers of a plan.
 *
 *   Ar   = rho_f (rho_p - rho_f) |g| d^3/mu^2                     Archimedes number [1]
 *   U_mf = Re mu/(rho_f d),  Re = sqrt(33.7^2 + 0.0408 Ar) - 33.7  superficial velocity at minimum fluidisation [m/s]
 *   tau  = rho_p d^2/(18 mu)                                      time in which a sphere follows a creeping fluid [s]
 *
 * With the scene's own law of drag the bed is carried where the drag b u on a sphere balances
 *
 *   e (rho_p - rho_f) V |g|     when the pressure gradient acts on particles: of the weight less buoyancy the share
 *                               1 - e is carried by the gradient that drag itself makes (set II, "model A")
 *   rho_p V |g|                 when it does not
 *
 * and U_mf = e u. The void fraction is Wen and Yu's own for spheres, 1/e^3 = 14.
 *
 *   d    diameter; of a mixture the Sauter mean, sum d^3/sum d^2   [m]
 *   rho_p, rho_f, mu   densities of particle and fluid, viscosity  [kg/m3], [Pa s]
 *   u    interstitial velocity; e void fraction; V volume          [m/s], [1], [m3]
 *
 * Source: Wen and Yu, AIChE J. 12 (1966) 610; the balance: Gidaspow, Multiphase Flow and Fluidization (1994), section 2.5.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_PLAN_FLUIDISE_H
#define DEM_PLAN_FLUIDISE_H

#include "state/recipe.h"

struct dem_bed                                            /* one kind of sphere in one fluid */
{
    double diameter, density;                             /* m, kg/m3 */
    double fluid_density, viscosity;                      /* kg/m3, Pa s */
    double gravity;                                       /* m/s2 */
    int feels_gradient;                                   /* 1: the pressure gradient acts on particles */
};

/* void fraction where the bed begins to move, 14^(-1/3) */
#define DEM_BED_VOID 0.41491326668312173

double dem_bed_archimedes(const struct dem_bed *);
double dem_bed_wen_yu(const struct dem_bed *);            /* m/s  U_mf; 0 where nothing sinks */
double dem_bed_response(const struct dem_bed *);          /* s    tau */

/* The drag coefficient b [kg/s] of one sphere by the scene's law of drag, 0 without one; u is the slip [m/s]. */
double dem_bed_drag(const struct dem_recipe *, const struct dem_bed *, double void_fraction, double u);

/* m/s: U_mf by the scene's law of drag, superficial; 0 without one, or where nothing sinks. */
double dem_bed_balance(const struct dem_recipe *, const struct dem_bed *, double void_fraction);

/* m/s: the speed at which one sphere sinks in the fluid at rest, by the scene's law of drag; 0 without one. */
double dem_bed_terminal(const struct dem_recipe *, const struct dem_bed *);

#endif
