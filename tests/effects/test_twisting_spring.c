/*
 * test_twisting_spring.c -- the twisting spring has the stiffness of Reissner and Sagoci, the
 * limit of Hertz's pressure, and the time to rest.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "moments.h"

static struct impacts w;

static void spring(void)
{
    struct impacts_effect *l = moments_row(&w, &dem_twisting_spring, "friction", 0.5);
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

/* the sphere on its plane, spinning about z; angular frequency over 5 periods */
static void oscillation(void)
{
    const double dt = moments_plane(&w, &dem_twisting_spring, "friction", 100.0, 0.5);
    const double a = sqrt(0.004*moments_depth(&w, 9.81)), G = 1e6/2.5;
    const double omega = sqrt(8.0/3.0*G*a*a*a/(0.4*w.mass[0]*0.004*0.004));
    double before = 0.0, angle = 0.0, first = 0.0, last = 0.0;
    int passages = 0, steps = 0;

    w.w[0][2][0] = 1e-3*omega;
    for (; passages < 11 && steps*dt*omega < 100.0; steps++)
    {
        before = angle;
        impacts_step(&w, dt);
        angle += dt*w.w[0][2][0];
        if (before*angle < 0.0)
        {
            last = (steps + before/(before - angle))*dt;
            first = passages++ == 0 ? last : first;
        }
    }
    TAP_NEAR((last - first)*omega/(10.0*moments_pi), 1.0, 1e-4, "oscillates at %g 1/s",
             omega);    /* (dt omega)^2/24 and reading */
}

/* times to rest: the limit torque of the contact area and of the reduced radius */
static void rest(void)
{
    for (int lever = 0; lever < 2; lever++)
    {
        const double mu = lever ? 0.01 : 0.5, spin = 20.0,
                     dt = moments_plane(&w, &dem_twisting_spring, "friction", mu, 0.5);
        const double a = sqrt(0.004*moments_depth(&w, 9.81)),
                     arm = lever ? 0.004 : 3.0*moments_pi/16.0*a;
        const double expected = 0.4*0.004*0.004*spin/(mu*arm*9.81);
        double time = 0.0;

        apply_setting(&dem_twisting_spring, w.effect_entry[3].settings, &w.pair, "lever", lever);
        w.w[0][2][0] = spin;
        while (w.w[0][2][0] > 0.0 && time < 3.0*expected)
        {
            impacts_step(&w, dt);
            time += dt;
        }
        /* less torque until the spring is at its limit: 1e-3 of the angle; whole steps */
        TAP_NEAR(time/expected, 1.0, 3e-3, "a spinning sphere rests after %g s", time);
        TAP_OK(fabs(w.v[0][0][0]) + fabs(w.w[0][0][0]) == 0.0, "it has not moved");
    }
}

int main(void)
{
    TAP_TRAPS;
    spring();
    moments_common(&w, &dem_twisting_spring, "friction", 0.5);
    oscillation();
    rest();
    TAP_DONE;
}
