/*
 * test_rolling_constant.c -- rolling resistance of constant torque.
 *
 * - The torque is mu_r R* max(F_n, 0) against the rolling component of the relative spin, at any
 *   speed, and never reverses the spin in a step; none at rest.
 * - A sphere on a plane: physics/test_moments.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "moments.h"

static struct law_rows w;

static void torque(void)
{
    struct rows_effect *const l = moments_row(&w, &dem_rolling_constant, "friction", 0.1);

    /* rounding */
    w.b.wx[0] = 30.0, w.b.wy[0] = 40.0, w.b.wz[0] = 1e3;
    moments_evaluate(&w, l);
    TAP_NEAR(w.b.mx[0], -0.6*0.1*0.004*10.0, 1e-17, "mu_r R F_n against the spin, component x");
    TAP_NEAR(w.b.my[0], -0.8*0.1*0.004*10.0, 1e-17, "component y");
    TAP_OK(w.b.mz[0] == 0.0, "twist is not rolling");
    w.b.wx[0] = 3e3, w.b.wy[0] = 4e3;
    moments_evaluate(&w, l);
    TAP_NEAR(moments_size(&w), 0.1*0.004*10.0, 1e-17, "the same at a hundred times the spin");

    /* 2/5 m R^2/dt = 6.4e-3 N m s: spins below 0.625 1/s would be reversed */
    w.b.wx[0] = 0.3, w.b.wy[0] = 0.4;
    moments_evaluate(&w, l);
    TAP_NEAR(moments_size(&w), 6.4e-3*0.5, 1e-16,
             "below that: the torque that stops it in the step");
    w.b.wx[0] = 0.6249, w.b.wy[0] = 0.0;
    moments_evaluate(&w, l);
    TAP_NEAR(moments_size(&w), 4e-3, 1e-6, "continuous at 0.625 1/s");       /* 0.6249 of 0.625 */
    w.b.wx[0] = 0.0;
    moments_evaluate(&w, l);
    TAP_OK(moments_size(&w) == 0.0, "twist alone: no torque");
}

int main(void)
{
    TAP_TRAPS;
    torque();
    moments_common(&w, &dem_rolling_constant, "friction", 0.1);
    TAP_DONE;
}
