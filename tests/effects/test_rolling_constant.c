/*
 * Claims: the torque is mu_r R* max(F_n, 0) against the rolling part of the relative spin, at any speed, and never takes
 * away more than the spin there is; none at rest; a sphere that rolls on a plane stops after 7 v^2/(10 mu_r g) and stays.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "moments.h"

static struct impacts w;

static void torque(void)
{
    struct impacts_effect *const l = moments_row(&w, &dem_rolling_constant, "friction", 0.1);

    /* rounding */
    w.b.wx[0] = 30.0, w.b.wy[0] = 40.0, w.b.wz[0] = 1e3;
    moments_act(&w, l);
    TAP_NEAR(w.b.mx[0], -0.6*0.1*0.004*10.0, 1e-17, "mu_r R F_n against the spin, x");
    TAP_NEAR(w.b.my[0], -0.8*0.1*0.004*10.0, 1e-17, "and y");
    TAP_OK(w.b.mz[0] == 0.0, "twist is not rolling");
    w.b.wx[0] = 3e3, w.b.wy[0] = 4e3;
    moments_act(&w, l);
    TAP_NEAR(moments_size(&w), 0.1*0.004*10.0, 1e-17, "the same a hundred times as fast");

    /* 2/5 m R^2/dt = 6.4e-3 N m s: spins below 0.625 1/s would be turned round */
    w.b.wx[0] = 0.3, w.b.wy[0] = 0.4;
    moments_act(&w, l);
    TAP_NEAR(moments_size(&w), 6.4e-3*0.5, 1e-16,
             "slower than a step can stop: as much as stops it");
    w.b.wx[0] = 0.6249, w.b.wy[0] = 0.0;
    moments_act(&w, l);
    TAP_NEAR(moments_size(&w), 4e-3, 1e-6, "both meet at 0.625 1/s");       /* 0.6249 of 0.625 */
    w.b.wx[0] = 0.0;
    moments_act(&w, l);
    TAP_OK(moments_size(&w) == 0.0, "twist alone: nothing");
}

static void rest(void)
{
    static const double mu[] = {0.005, 0.02}, speed[] = {0.05, 0.1};

    for (int k = 0; k < 2; k++)
    {
        const double dt = moments_plane(&w, &dem_rolling_constant, "friction", mu[k], 10.0);
        double time;
        const double distance = moments_rest(&w, dt, speed[k], &time);

        /* stopped at 1e-4 of the speed; the contact's spring stretches by a few 1e-4 of the way when the torque sets in */
        TAP_NEAR(distance/(0.7*speed[k]*speed[k]/(mu[k]*9.81)), 1.0, 1e-3,
                 "mu_r %g: rolls %.4f m", mu[k], distance);
        TAP_NEAR(time/(1.4*speed[k]/(mu[k]*9.81)), 1.0, 1e-3, "in %.4f s", time);
        for (int s = 0; s < 20000; s++)
        {
            impacts_step(&w, dt);
        }
        TAP_NEAR(w.x[0][0][0], distance, 1e-4*distance, "and stays there");
        TAP_NEAR(w.w[0][1][0], 0.0, 1e-9*speed[k]/0.004, "without jitter: turns with %g 1/s",
                 w.w[0][1][0]);
        TAP_NEAR(w.v[0][0][0], 0.0, 1e-9*speed[k], "moves with %g m/s", w.v[0][0][0]);
    }
}

int main(void)
{
    TAP_TRAPS;
    torque();
    moments_none(&w, &dem_rolling_constant, "friction", 0.1);
    moments_axes(&w, &dem_rolling_constant, "friction", 0.1);
    rest();
    TAP_DONE;
}
