/*
 * test_saffman_mei.c -- shear lift of Saffman and Mei.
 *
 * - In a shear flow a lagging sphere is pushed towards the faster fluid, a leading one towards the
 *   slower.
 * - At small Re_p the force is Saffman's 1.615 mu d w sqrt(Re_shear); in the range of Mei's fit it
 *   is Mei's, with the second branch at Re_p = 100.
 * - Without slip, without shear and for slip along the vorticity there is no lift.
 * - The force is normal to slip and vorticity.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "bodies.h"

static struct dem_body_batch b;

/* a sphere of diameter d at rest, the fluid with velocity w along x and shear du/dy = G: vorticity
   -G along z */
static void in_shear(double d, double rho, double mu, double w, double G)
{
    memset(&b, 0, sizeof b);
    b.n = 1;
    body_fill(&b, 0, d, rho, mu, 1.0, 0.0);
    b.ux[0] = w, b.oz[0] = -G;
    dem_saffman_mei.apply_to_bodies(NULL, &b);
}

int main(void)
{
    const double d = 1e-4, rho = 1000.0, mu = 1e-3, nu = mu/rho;

    TAP_TRAPS;
    /* Re_p = 1e-4, Re_shear = 1e-2: k = 50, exp(-Re_p/10) = 1 - 1e-5, and 0.3314 sqrt k of that */
    in_shear(d, rho, mu, 1e-6, 1.0);
    TAP_NEAR(b.ry[0]/(1.615*mu*d*1e-6*sqrt(d*d/nu)), 1.0, 5e-5, "small Re_p: Saffman's");
    TAP_OK(b.ry[0] > 0.0 && b.rx[0] == 0.0 && b.rz[0] == 0.0,
           "a lagging sphere is pushed towards the faster fluid");
    in_shear(d, rho, mu, -1e-6, 1.0);
    TAP_OK(b.ry[0] < 0.0, "a leading one towards the slower fluid");
    in_shear(d, rho, mu, 1e-6, -1.0);
    TAP_OK(b.ry[0] < 0.0, "in the opposite shear the opposite");

    /* Re_p = 20, k = 0.1: Mei's table gives J = (1 - 0.3314 sqrt 0.1) e^-2 + 0.3314 sqrt 0.1 =
       0.2259 */
    const double w = 20.0*nu/d, G = 0.1*2.0*w/d;

    in_shear(d, rho, mu, w, G);
    TAP_NEAR(b.ry[0]/(1.615*mu*d*w*sqrt(G*d*d/nu)), 0.22595, 1e-5, "Re_p = 20: Mei's fraction of it");
    in_shear(d, rho, mu, 5.0*w, 5.0*G);
    TAP_NEAR(b.ry[0]/(1.615*mu*d*5.0*w*sqrt(5.0*G*d*d/nu)),
             0.0524*sqrt(0.1*100.0), 1e-12, "Re_p = 100: Mei's second branch");    /* rounding */
    in_shear(d, rho, mu, 39.999/20.0*w, 39.999/20.0*G);
    const double below = b.ry[0]/pow(39.999, 1.5);

    in_shear(d, rho, mu, 40.001/20.0*w, 40.001/20.0*G);
    const double root = 0.3314*sqrt(0.1);

    /* 5e-5 of Re_p apart */
    TAP_NEAR(b.ry[0]/pow(40.001, 1.5)/below,
             0.0524*sqrt(4.0)/((1.0 - root)*exp(-4.0) + root), 1e-4,
             "the step at Re_p = 40 is the published one");

    in_shear(d, rho, mu, 0.0, G);
    TAP_OK(b.rx[0] == 0.0 && b.ry[0] == 0.0, "without slip: no lift");
    in_shear(d, rho, mu, w, 0.0);
    TAP_OK(b.rx[0] == 0.0 && b.ry[0] == 0.0, "without shear: no lift");
    in_shear(d, rho, 0.0, w, G);
    TAP_OK(b.ry[0] == 0.0, "without viscosity: none");
    in_shear(d, rho, mu, 1e-200, 1e-200);
    TAP_OK(isfinite(b.ry[0]), "very small slip: finite");

    memset(&b, 0, sizeof b);
    b.n = 2;
    for (int c = 0; c < 2; c++)
    {
        body_fill(&b, c, d, rho, mu, 1.0, 0.0);
        b.ux[c] = 0.03, b.uy[c] = -0.01, b.uz[c] = 0.02;
        b.vx[c] = 0.01, b.vy[c] = 0.005, b.vz[c] = -0.01;
        b.ox[c] = 30.0, b.oy[c] = -20.0, b.oz[c] = 10.0;
    }
    b.ox[1] = 20.0*7.0, b.oy[1] = -15.0*7.0, b.oz[1] = 30.0*7.0;
    dem_saffman_mei.apply_to_bodies(NULL, &b);
    const double size = fabs(b.rx[0]) + fabs(b.ry[0]) + fabs(b.rz[0]);

    /* rounding of three products */
    TAP_NEAR((b.rx[0]*0.02 - b.ry[0]*0.015 + b.rz[0]*0.03)/(0.03*size), 0.0, 1e-15,
             "normal to the slip");
    TAP_NEAR((b.rx[0]*30.0 - b.ry[0]*20.0 + b.rz[0]*10.0)/(30.0*size), 0.0, 1e-15,
             "normal to the vorticity");
    TAP_NEAR((fabs(b.rx[1]) + fabs(b.ry[1]) + fabs(b.rz[1]))/size, 0.0, 1e-12,
             "slip along the vorticity: none");
    TAP_OK(b.fx[0] == 0.0 && b.drag[0] == 0.0, "only in the column that the fluid receives");
    TAP_DONE;
}
