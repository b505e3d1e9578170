/*
 * exchange.h -- what a coupled fluid and its particles are told of each other.
 *
 * How much faster particles lose their slip where an incompressible fluid makes room for them (step/sweep_bodies.c):
 *
 *   c = 1/e^2            by 1/e for the fluid's motion, and as much again for the pressure gradient that comes with it
 *   c = 1/e              where drag is that over e, which holds the pressure gradient's part (set III of Zhou et al. 2010)
 *
 * The force F - K u of a particle on the fluid, u its velocity after the step:
 *
 *   deferred             K = R/T      F = K u* - J/T            the particle gets R (u - u*) in the next step
 *   semiImplicit         K = B/T      F = K v + J_d/T - J/T     drag at the particle's velocity of now; momentum is not kept
 *   explicit             K = 0        F = -J/T
 *
 * The rate at which drag takes up slip, and the mean diameter of a mixture, Sauter's:
 *
 *   1/tau = B/T/(m + a),     d = sum V/sum (V/d_i)
 *
 *   e        void fraction, taken from 0.1 on                           [1]
 *   u*, v    velocity of the fluid before the step, of the particle     [m/s]
 *   J, J_d   impulse on the particle in the step, that of drag in it    [N s]
 *   R, B     response dJ/du; sum of drag's coefficient times time       [kg]
 *   T        the step in which fluid and particles exchange             [s]
 *   m, a     mass of the particle, added mass                           [kg]
 *   V, d_i   volume and diameter of the particles around                [m3], [m]
 *
 * Source: Zhou, Kuang, Chu, Yu, J. Fluid Mech. 661 (2010) 482 for the sets of equations; the semi-implicit form is that of Xu and Yu,
 * Chem. Eng. Sci. 52 (1997) 2785, as most codes have it; Sauter, VDI-Forschungsheft 279 (1926).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_EXCHANGE_H
#define DEM_EFFECTS_EXCHANGE_H

static inline double dem_exchange_counterflow(double void_fraction, int whole_drag)
{
    const double e = void_fraction > 0.1 ? void_fraction : 0.1;

    return whole_drag ? 1.0/e : 1.0/(e*e);
}

/* One component of F, K times the velocity that it is taken at, and the impulse that K holds [N s]. */
static inline double dem_exchange_force(double coefficient, double velocity, double held, double impulse, double window)
{
    return coefficient*velocity + held/window - impulse/window;
}

static inline double dem_exchange_rate(double drag_time, double window, double over_inertia)
{
    return drag_time*over_inertia/window;
}

static inline double dem_exchange_sauter(double volume, double per_diameter)
{
    return per_diameter > 0.0 && volume > 0.0 ? volume/per_diameter : 0.0;
}

#endif
