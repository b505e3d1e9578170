/*
 * minimum_fluidisation.h -- dimensionless numbers and velocities of fluidisation for `dem plan`.
 *
 *   Ar   = rho_f (rho_p - rho_f) |g| d^3/mu^2                     Archimedes number [1]
 *   U_mf = Re mu/(rho_f d),  Re = sqrt(33.7^2 + 0.0408 Ar) - 33.7  superficial velocity at minimum
 *                                                                 fluidisation [m/s]
 *   tau  = rho_p d^2/(18 mu)                                      Stokes response time [s]
 *
 * With the drag law of the scene the bed is fluidised where the drag b u on a sphere balances
 *
 *   e (rho_p - rho_f) V |g|     if the pressure gradient acts on particles: the fraction 1 - e of
 *                               the weight less buoyancy is supported by the pressure gradient that
 *                               the drag itself causes (set II, "model A")
 *   rho_p V |g|                 if it does not
 *
 * and U_mf = e u. The void fraction is measured in the bed as it is (dem_bed_void_fraction); where it is not
 * known, or too large for particles that touch, it is Wen and Yu's for spheres, 1/e^3 = 14.
 *
 * A fluidised bed expands until the same balance holds at the superficial velocity U of the fluid.
 * Measured beds of spheres in liquids, without wall effect (Re_t = rho_f u_t d/mu):
 *
 *   U = u_t e^n,  n = 4.65                 Re_t < 0.2
 *                     4.35 Re_t^-0.03      < 1
 *                     4.45 Re_t^-0.1       < 500
 *                     2.39                 above
 *
 *   d    diameter; of a mixture the Sauter mean, sum d^3/sum d^2   [m]
 *   rho_p, rho_f, mu   densities of particle and fluid, viscosity  [kg/m3], [Pa s]
 *   u    interstitial velocity; e void fraction; V volume          [m/s], [1], [m3]
 *
 *   u_t  terminal velocity of one sphere (Schiller and Naumann)    [m/s]
 *
 * Source: Wen and Yu, AIChE J. 12 (1966) 610; the balance: Gidaspow, Multiphase Flow and
 * Fluidization (1994), section 2.5; expansion: Richardson and Zaki, Trans. Inst. Chem. Eng. 32
 * (1954) 35.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_numbers.h"

/* void fraction at minimum fluidisation of a bed that is not known, 14^(-1/3) */
#define DEM_SUSPENSION_VOID_FRACTION 0.41491326668312173

double dem_suspension_archimedes(const struct dem_suspension *);
/* m/s  U_mf; 0 if the particles do not sink */
double dem_suspension_wen_yu_velocity(const struct dem_suspension *);
double dem_suspension_response_time(const struct dem_suspension *);          /* s    tau */

/* m/s: superficial U_mf with the drag law of the scene; 0 without one, or if the particles do
   not sink. */
double dem_suspension_fluidisation_velocity(const struct dem *,
                                            const struct dem_suspension *, double void_fraction);

/* 1: void fraction at which the drag law of the scene balances the bed in a fluid of superficial
   velocity U [m/s]; 0 below the void fraction `packed`, 1 above the terminal velocity. */
double dem_suspension_expanded_void_fraction(const struct dem *,
                                             const struct dem_suspension *, double packed,
                                             double U);

/* 1: the same by Richardson and Zaki, at most 1 */
double dem_suspension_richardson_zaki(const struct dem_suspension *, double U);

/* m/s: terminal velocity of one sphere with the drag law of the scene; 0 without one. */
double dem_suspension_terminal_velocity(const struct dem *,
                                        const struct dem_suspension *);
