/*
 * test_rolling_viscous.c -- viscous rolling resistance.
 *
 * - The torque is A max(F_n, 0) R* times the rolling component of the relative spin and never
 *   reverses the spin in a step.
 * - A sphere on a plane: physics/test_moments.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "moments.h"

static struct law_rows w;

static void torque(void)
{
    struct rows_effect *l = moments_row(&w, &dem_rolling_viscous, "time", 1e-3);

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

int main(void)
{
    TAP_TRAPS;
    torque();
    moments_common(&w, &dem_rolling_viscous, "time", 1e-3);
    TAP_DONE;
}
