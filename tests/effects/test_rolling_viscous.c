/*
 * test_rolling_viscous.c -- viscous rolling resistance.
 *
 * - The torque is A max(F_n, 0) R* times the rolling component of the relative spin and never
 *   reverses the spin in a step.
 * - A sphere that rolls on a plane slows down as e^(-t/T), T = 7 R/(5 A g), over a distance of v T.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "moments.h"

static struct impacts w;

static void torque(void)
{
    struct impacts_effect *l = moments_row(&w, &dem_rolling_viscous, "time", 1e-3);

    /* rounding */
    w.b.wx[0] = 30.0, w.b.wy[0] = 40.0, w.b.wz[0] = 1e3;
    moments_evaluate(&w, l);
    TAP_NEAR(w.b.mx[0], -30.0*1e-3*10.0*0.004, 1e-16, "A F_n R w against the spin, component x");
    TAP_NEAR(w.b.my[0], -40.0*1e-3*10.0*0.004, 1e-16, "component y");
    TAP_OK(w.b.mz[0] == 0.0, "twist is not rolling");
    l = moments_row(&w, &dem_rolling_viscous, "time", 1e9);
    w.b.wx[0] = 30.0;
    moments_evaluate(&w, l);
    TAP_NEAR(w.b.mx[0], -30.0*0.4*1e-3*0.004*0.004/1e-6, 1e-13, "at most the torque that stops it in a step");
}

static void slowing(void)
{
    const double A = 2e-4, v = 0.05, dt = moments_plane(&w, &dem_rolling_viscous, "time", A, 10.0);
    const double T = 1.4*0.004/(A*9.81);
    const int steps = (int)(0.5*T/dt);

    w.v[0][0][0] = v;
    w.w[0][1][0] = v/0.004;
    for (int s = 0; s < steps; s++)
    {
        impacts_step(&w, dt);
    }
    /* the contact's springs oscillate by a few 1e-5 of v at the onset of the torque; first order in
       dt/T = 3e-5 */
    TAP_NEAR(w.v[0][0][0]/v, exp(-steps*dt/T), 2e-4, "speed after half of T = %g s", T);
    TAP_NEAR(w.w[0][1][0]*0.004/v, exp(-steps*dt/T), 2e-4, "spin after half of T");
    TAP_NEAR(w.x[0][0][0]/(v*T), 1.0 - exp(-steps*dt/T), 2e-4, "distance after half of T");
}

int main(void)
{
    TAP_TRAPS;
    torque();
    moments_common(&w, &dem_rolling_viscous, "time", 1e-3);
    slowing();
    TAP_DONE;
}
