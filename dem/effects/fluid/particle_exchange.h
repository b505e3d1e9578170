/*
 * particle_exchange.h -- momentum exchange between particles and a coupled fluid.
 *
 * Slip factor: how much faster the slip decays because an incompressible fluid flows back while
 * particles move (step/sweep_bodies.c):
 *
 *   c = 1/e^2            1/e by the motion of the fluid, and 1/e by the pressure gradient it causes
 *   c = 1/e              where the drag law is that over e, which contains the part of the pressure
 *                        gradient (set III of Zhou et al. 2010)
 *
 * The force F - K u of a particle on the fluid, u the fluid velocity after the step:
 *
 *   deferred         K = R/T    F = K u* - J/T          the particle gets R (u - u*) in the next
 *                                                       step
 *   semiImplicit     K = B/T    F = K v + J_d/T - J/T   drag at the present particle velocity;
 *                                                       momentum is not conserved
 *   explicit         K = 0      F = -J/T
 *
 * The rate at which drag removes slip, and the Sauter mean diameter of a mixture:
 *
 *   1/tau = B/T/(m + a),     d = sum V/sum (V/d_i)
 *
 * Under-relaxation. Pressure gradient and Du/Dt act on a particle one step late. In one cell
 * without drag, what particles do with them returns multiplied by -lambda,
 *
 *   lambda = (1 - e)/e/(2 delta) (1 + 2 C + sqrt((1 + 2 C)^2 - 4 C delta)),  delta = rho_p/rho + C
 *
 * Above a magnitude of 1 this grows, the faster the shorter the step; drag that transmits the
 * fraction q of a force to the fluid leaves 1 - q of it. So light particles feel
 *
 *   f' = f + w (g - f),   w = 1/(1 + |lambda| (1 - q))
 *
 * with g the value in the fluid. The model of one cell is then stable for density ratios from 0.001
 * to 100, C = 0, 1/2 and Zuber's, e from 0.3, any drag (tests/effects/test_exchange.c).
 *
 *   e        void fraction, at least 0.1                                [1]
 *   u*, v    fluid velocity before the step, particle velocity          [m/s]
 *   J, J_d   impulse on the particle in the step, and its drag part     [N s]
 *   R, B     response dJ/du; sum of drag coefficient times time         [kg]
 *   T        the step in which fluid and particles exchange momentum    [s]
 *   m, a     mass of the particle, added mass                           [kg]
 *   C        added mass over the mass of displaced fluid                [1]
 *   V, d_i   volume and diameter of the surrounding particles           [m3], [m]
 *
 * Source: Zhou, Kuang, Chu, Yu, J. Fluid Mech. 661 (2010) 482 for the sets of equations; the
 * semi-implicit form is that of Xu and Yu, Chem. Eng. Sci. 52 (1997) 2785, as in most codes;
 * Sauter, VDI-Forschungsheft 279 (1926).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_PARTICLE_EXCHANGE_H
#define DEM_EFFECTS_PARTICLE_EXCHANGE_H

#include <math.h>

/* Particles of at least so many times the fluid's density need no under-relaxation. */
#define DEM_EXCHANGE_LIGHT 10.0

/* Slip factor c; whole_drag: 1: the drag law contains the pressure gradient (set III). */
static inline double dem_exchange_slip_factor(double void_fraction, int whole_drag)
{
    const double e = void_fraction > 0.1 ? void_fraction : 0.1;

    return whole_drag ? 1.0/e : 1.0/(e*e);
}

/* One component of F [N]: coefficient is K, velocity that which K multiplies (u*, v or 0), held
   the part of the impulse that K contains [N s] (J_d or 0), impulse J, window T. */
static inline double dem_exchange_force(double coefficient, double velocity, double held,
                                        double impulse, double window)
{
    return coefficient*velocity + held/window - impulse/window;
}

/* 1/tau [1/s]; drag_time is B, over_inertia 1/(m + a) */
static inline double dem_exchange_rate(double drag_time, double window, double over_inertia)
{
    return drag_time*over_inertia/window;
}

/* Under-relaxation factor w of the pressure gradient and of Du/Dt at a particle: density_ratio is
   rho_p/rho, added C, transmitted q */
static inline double dem_exchange_under_relaxation(double void_fraction, double density_ratio,
                                                   double added, double transmitted)
{
    const double e = void_fraction > 0.1 ? void_fraction : 0.1, s = e < 1.0 ? 1.0 - e : 0.0;
    const double delta = density_ratio + added, b = 1.0 + 2.0*added,
                 square = b*b - 4.0*added*delta;
    /* of the larger eigenvalue; of a conjugate pair both have this magnitude */
    const double magnitude =
        s/e*(square > 0.0 ? (b + sqrt(square))/(2.0*delta) : sqrt(added/delta));

    return 1.0/(1.0 + magnitude*(1.0 - transmitted));
}

/* d [m]: volume is sum V, per_diameter sum (V/d_i); 0 without particles */
static inline double dem_exchange_sauter(double volume, double per_diameter)
{
    return per_diameter > 0.0 && volume > 0.0 ? volume/per_diameter : 0.0;
}

#endif
