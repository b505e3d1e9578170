/*
 * test_exchange.c -- the impulse that the schemes of the exchange give to the fluid.
 *
 * - The slip factor is 1/e^2, or 1/e with whole drag, and bounded below e = 0.1.
 * - The three schemes give the fluid the impulse J if its velocity has not changed, and the stated
 *   part of a change otherwise.
 * - The Sauter mean of two sizes is that of their volumes and surfaces, and 0 without particles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "unit/tap.h"
#include "effects/fluid/particle_exchange.h"

int main(void)
{
    TAP_TRAPS;
    /* products of round numbers: rounding */
    TAP_NEAR(dem_exchange_slip_factor(0.4, 0), 6.25, 1e-14, "the slip factor at e = 0.4");
    TAP_NEAR(dem_exchange_slip_factor(0.4, 1), 2.5, 1e-15, "with whole drag");
    TAP_OK(dem_exchange_slip_factor(1.0, 0) == 1.0 && dem_exchange_slip_factor(1.0, 1) == 1.0,
           "slip factor without particles");
    TAP_OK(dem_exchange_slip_factor(-0.2, 0) == dem_exchange_slip_factor(0.1, 0),
           "bounded at void fraction 0");

    /* b = 2e-6 kg/s for T = 1e-3 s at u = 0.5, v = 0.2 m/s held still: J = b T (u - v), R = B =
       b T */
    const double T = 1e-3, B = 2e-6*T, u = 0.5, v = 0.2, J = B*(u - v), K = B/T;

    TAP_NEAR(dem_exchange_force(K, u, 0.0, J, T) - K*u, -J/T, 1e-15*K,
             "deferred: -J/T at the previous velocity");
    TAP_NEAR(dem_exchange_force(K, u, 0.0, J, T) - K*(u + 0.1), -(J + B*0.1)/T, 1e-15*K,
             "deferred: R du more at another velocity");
    TAP_NEAR(dem_exchange_force(K, v, J, J, T) - K*u, -K*(u - v), 1e-15*K,
             "semi-implicit: the present slip");
    TAP_NEAR(dem_exchange_force(0.0, v, 0.0, J, T), -J/T, 1e-15*K, "explicit: -J/T");

    /* 8 spheres of d = 1, one of d = 2: sum d^3/sum d^2 = 16/12 */
    TAP_NEAR(dem_exchange_sauter(8.0 + 8.0, 8.0 + 4.0), 4.0/3.0, 1e-15, "Sauter's mean");
    TAP_OK(dem_exchange_sauter(0.0, 0.0) == 0.0 && dem_exchange_sauter(-1e-30, 1e-40) == 0.0,
           "Sauter mean without particles: 0");
    TAP_DONE;
}
