/*
 * Claims: the slip factor is 1/e^2, or 1/e with the whole drag, and bounded below e = 0.1. The three forms of the exchange give the
 * fluid the impulse J where nothing has changed, and the stated part of a change otherwise. The Sauter mean of two sizes is that of
 * their volumes and surfaces, and 0 without particles.
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
           "none where there are no particles");
    TAP_OK(dem_exchange_slip_factor(-0.2, 0) == dem_exchange_slip_factor(0.1, 0),
           "bounded where the void fraction is none");

    /* b = 2e-6 kg/s for T = 1e-3 s at u = 0.5, v = 0.2 m/s held still: J = b T (u - v), R = B = b T */
    const double T = 1e-3, B = 2e-6*T, u = 0.5, v = 0.2, J = B*(u - v), K = B/T;

    TAP_NEAR(dem_exchange_force(K, u, 0.0, J, T) - K*u, -J/T, 1e-15*K,
             "deferred: -J/T at the velocity of before");
    TAP_NEAR(dem_exchange_force(K, u, 0.0, J, T) - K*(u + 0.1), -(J + B*0.1)/T, 1e-15*K,
             "and R du more at another");
    TAP_NEAR(dem_exchange_force(K, v, J, J, T) - K*u, -K*(u - v), 1e-15*K,
             "semi-implicit: the slip of now");
    TAP_NEAR(dem_exchange_force(0.0, v, 0.0, J, T), -J/T, 1e-15*K, "explicit: -J/T");

    /* 8 spheres of d = 1, one of d = 2: sum d^3/sum d^2 = 16/12 */
    TAP_NEAR(dem_exchange_sauter(8.0 + 8.0, 8.0 + 4.0), 4.0/3.0, 1e-15, "Sauter's mean");
    TAP_OK(dem_exchange_sauter(0.0, 0.0) == 0.0 && dem_exchange_sauter(-1e-30, 1e-40) == 0.0,
           "no particle around");
    TAP_DONE;
}
