/*
 * Claims: the torque is A max(F_n, 0) R* times the rolling part of the relative spin and never takes away more than there
 * is; a sphere that rolls on a plane slows as e^(-t/T), T = 7 R/(5 A g), over a way of v T.
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
    moments_act(&w, l);
    TAP_NEAR(w.b.mx[0], -30.0*1e-3*10.0*0.004, 1e-16, "A F_n R w against the spin, x");
    TAP_NEAR(w.b.my[0], -40.0*1e-3*10.0*0.004, 1e-16, "and y");
    TAP_OK(w.b.mz[0] == 0.0, "twist is not rolling");
    l = moments_row(&w, &dem_rolling_viscous, "time", 1e9);
    w.b.wx[0] = 30.0;
    moments_act(&w, l);
    TAP_NEAR(w.b.mx[0], -30.0*0.4*1e-3*0.004*0.004/1e-6, 1e-13, "at most what stops it in a step");
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
    /* the contact's springs swing by a few 1e-5 of v when the torque sets in; first order in dt/T = 3e-5 */
    TAP_NEAR(w.v[0][0][0]/v, exp(-steps*dt/T), 2e-4, "speed after half of T = %g s", T);
    TAP_NEAR(w.w[0][1][0]*0.004/v, exp(-steps*dt/T), 2e-4, "and spin");
    TAP_NEAR(w.x[0][0][0]/(v*T), 1.0 - exp(-steps*dt/T), 2e-4, "and way");
}

int main(void)
{
    TAP_TRAPS;
    torque();
    moments_none(&w, &dem_rolling_viscous, "time", 1e-3);
    moments_axes(&w, &dem_rolling_viscous, "time", 1e-3);
    slowing();
    TAP_DONE;
}
