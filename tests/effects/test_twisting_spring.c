/*
 * test_twisting_spring.c -- the twisting spring has the stiffness of Reissner and Sagoci, and the
 * limit of Hertz's pressure.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "moments.h"

static struct law_rows w;

static void spring(void)
{
    struct rows_effect *l = moments_row(&w, &dem_twisting_spring, "friction", 0.5);
    const double G = 1e6/2.5, a = sqrt(0.004*1e-6);

    /* Reissner and Sagoci: 16/3 G a^3 on a rigid stamp, each of two halves gets half the angle; k_n
       is Hertz's here */
    w.b.kn[0] = 4.0/3.0*w.pair.reduced_modulus*a;
    w.b.wz[0] = 2.0, w.b.wx[0] = 1e4;
    moments_evaluate(&w, l);
    moments_evaluate(&w, l);
    TAP_NEAR(w.b.mz[0], -8.0/3.0*G*a*a*a*4e-6, 1e-14*8.0/3.0*G*a*a*a*4e-6,
             "8/3 G a^3 times the angle");    /* rounding */
    TAP_OK(w.b.mx[0] == 0.0 && w.b.my[0] == 0.0, "rolling is not twisting");

    w.b.wz[0] = 1e9;
    moments_evaluate(&w, l);
    TAP_NEAR(w.b.mz[0], -3.0*moments_pi/16.0*0.5*a*10.0, 1e-15, "slips at 3 pi/16 mu a F_n");
    w.b.wz[0] = 0.0;
    moments_evaluate(&w, l);
    TAP_NEAR(w.b.mz[0], -3.0*moments_pi/16.0*0.5*a*10.0, 1e-15, "the moment stays at the limit when the slip stops");

    /* 3 pi/16 from the integral of r times Hertz's pressure, 3 F/(2 pi a^2) sqrt(1 - r^2/a^2), over
       the circle: midpoints, 1e-6 */
    double sum = 0.0;

    for (int k = 0; k < 100000; k++)
    {
        const double r = (k + 0.5)*1e-5;

        sum += 1e-5*2.0*moments_pi*r*r*3.0/(2.0*moments_pi)*sqrt(1.0 - r*r);
    }
    TAP_NEAR(sum, 3.0*moments_pi/16.0, 1e-6, "3 pi/16 is the integral over Hertz's pressure");

    l = moments_row(&w, &dem_twisting_spring, "friction", 0.5);
    apply_setting(&dem_twisting_spring, l->settings, &w.pair, "lever", 1.0);
    w.b.wz[0] = -1e9;
    moments_evaluate(&w, l);
    TAP_NEAR(w.b.mz[0], 0.5*0.004*10.0, 1e-16, "with the reduced radius it slips at mu R F_n");

    l = moments_row(&w, &dem_twisting_spring, "friction", 0.5);
    apply_setting(&dem_twisting_spring, l->settings, &w.pair, "damping", 0.3);
    w.b.kn[0] = 4.0/3.0*w.pair.reduced_modulus*a;
    w.b.fn[0] = 1e9;
    w.b.wz[0] = 2.0;
    moments_evaluate(&w, l);
    const double k = 8.0/3.0*G*a*a*a, eta = 2.0*0.3*sqrt(k*0.4*1e-3*0.004*0.004);

    TAP_NEAR(w.b.mz[0]/(-k*2e-6 - eta*2.0), 1.0, 1e-14, "the dashpot of 2 zeta sqrt(k I)");
}

int main(void)
{
    TAP_TRAPS;
    spring();
    moments_common(&w, &dem_twisting_spring, "friction", 0.5);
    TAP_DONE;
}
