/*
 * test_viscous_torque.c -- torque of a viscous fluid.
 *
 * - At small Re the torque is pi mu d^3 times (half the vorticity less the spin); at larger Re the
 *   fit of Dennis and others, continuous in between.
 * - Target spin and coefficient belong together: a sphere that rotates with the fluid has no
 *   torque.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "bodies.h"

static struct dem_body_batch b;
static int correction = 1;

/* T over Stokes' at this Reynolds number of the spin */
static double factor(double re)
{
    const double d = 1e-3, rho = 1000.0, mu = 1e-3;

    memset(&b, 0, sizeof b);
    b.n = 1;
    body_fill(&b, 0, d, rho, mu, 1.0, 0.0);
    b.wz[0] = re*mu/(rho*d*d);
    dem_viscous_torque.apply_to_bodies(&correction, &b);
    return b.spin_drag[0]/(3.14159265358979324*mu*d*d*d);
}

int main(void)
{
    TAP_TRAPS;
    TAP_NEAR(factor(0.0), 1.0, 1e-15, "creeping: pi mu d^3");
    TAP_OK(factor(31.0) == factor(0.0), "up to Re_r = 31");
    for (double re = 40.0; re < 4000.0; re *= 2.0)
    {
        /* rho/2 R^5 C W^2, C = 12.9/sqrt Re + 128.4/Re, over pi mu d^3 W; rounding */
        TAP_NEAR(factor(re), (12.9/sqrt(re) + 128.4/re)*re/(64.0*3.14159265358979324),
                 1e-13, "Dennis and others at %g", re);
    }
    TAP_NEAR(factor(31.75)/factor(31.7), 1.0, 1e-3,
             "continuous at Re_r = 32");      /* slope of the fit: 2 % from 31 to 32 */
    correction = 0;
    TAP_OK(factor(1000.0) == factor(0.0), "without correction: Stokes'");
    correction = 1;

    memset(&b, 0, sizeof b);
    b.n = 3;
    for (int c = 0; c < 2; c++)
    {
        body_fill(&b, c, 1e-3, 1000.0, 1e-3, 0.7, 0.0);
        b.ox[c] = 4.0, b.oy[c] = -6.0, b.oz[c] = 2.0;
    }
    b.wx[1] = 2.0, b.wy[1] = -3.0, b.wz[1] = 1.0;
    dem_viscous_torque.apply_to_bodies(&correction, &b);
    TAP_OK(b.spin_drag_wx[0] == 2.0*b.spin_drag[0] && b.spin_drag_wy[0] == -3.0*b.spin_drag[0] &&
           b.spin_drag_wz[0] == b.spin_drag[0], "towards half the vorticity");
    TAP_OK(b.spin_drag_wx[1] - b.spin_drag[1]*b.wx[1] == 0.0 &&
           b.spin_drag_wz[1] - b.spin_drag[1]*b.wz[1] == 0.0,
           "no torque on a sphere that rotates with the fluid");
    TAP_OK(b.spin_drag[2] == 0.0 && b.spin_drag_wx[2] == 0.0, "an empty row: zero");
    TAP_OK(b.fx[0] == 0.0 && b.rx[0] == 0.0 && b.drag[0] == 0.0, "no force");
    TAP_DONE;
}
