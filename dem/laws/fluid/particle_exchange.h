/*
 * particle_exchange.h -- momentum exchange between particles and a coupled fluid.
 *
 * Slip factor, force F - K u on the fluid (u: its velocity after the step), rate at which drag
 * removes slip, Sauter mean diameter of a mixture, under-relaxation factor of the pressure gradient
 * and of Du/Dt at light particles. step/body_window.c computes R and q;
 * docs/theory-coupling.md, "Exchange", has the reasons.
 *
 *   gamma = 1/e^2, 1/e where the drag law contains the pressure gradient (set III)
 *   K = R/T,  F = K u* - J/T
 *   1/tau = B/T/(m + a),     d = sum V/sum (V/d_i)
 *   theta = 1/(1 + |lambda| (1 - q)),  delta = rho_p/rho + C_a,
 *   lambda = (1 - e)/e/(2 delta) (1 + 2 C_a + sqrt((1 + 2 C_a)^2 - 4 C_a delta))
 *
 *   e        void fraction, at least 0.1                                [1]
 *   u*       fluid velocity before the step                             [m/s]
 *   J        impulse on the particle in the step                        [N s]
 *   R, B     response dJ/du; sum of drag coefficient times time         [kg]
 *   T        the step in which fluid and particles exchange momentum    [s]
 *   m, a     mass of the particle, added mass                           [kg]
 *   C_a, q   added mass over the mass of displaced fluid; fraction of a force that drag transmits
 *   V, d_i   volume and diameter of the surrounding particles           [m3], [m]
 *
 * Source: Zhou, Kuang, Chu, Yu, J. Fluid Mech. 661 (2010) 482 for the sets of equations; Sauter,
 * VDI-Forschungsheft 279 (1926).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <math.h>

/* Particles of at least this many times the fluid's density need no under-relaxation and do not follow the
   fluid. */
#define DEM_EXCHANGE_LIGHT 10.0

/* Slip factor gamma; whole_drag: 1: the drag law contains the pressure gradient (set III). */
static inline double dem_exchange_slip_factor(double void_fraction, int whole_drag)
{
    const double e = void_fraction > 0.1 ? void_fraction : 0.1;

    return whole_drag ? 1.0/e : 1.0/(e*e);
}

/* One component of F [N]: coefficient is K, velocity u*, impulse J, window T. */
static inline double dem_exchange_force(double coefficient, double velocity, double impulse,
                                        double window)
{
    return coefficient*velocity - impulse/window;
}

/* 1/tau [1/s]; drag_integral is B, over_inertia 1/(m + a) */
static inline double dem_exchange_rate(double drag_integral, double window, double over_inertia)
{
    return drag_integral*over_inertia/window;
}

/* Under-relaxation factor theta of the pressure gradient and of Du/Dt at a particle: density_ratio
   is rho_p/rho, added C_a, transmitted q */
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
