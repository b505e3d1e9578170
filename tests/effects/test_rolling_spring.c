/*
 * test_rolling_spring.c -- the rolling spring has its stiffness, limit and dashpot, and rotates with
 * the pair. A sphere on a plane: physics/test_moments.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "moments.h"

static struct law_rows w;

/* K as set, or 6 G*:E* */
static struct rows_effect *row(double friction, double K, double zeta)
{
    struct rows_effect *const l = moments_row(&w, &dem_rolling_spring, "friction", friction);

    apply_setting(&dem_rolling_spring, l->settings, &w.pair, "damping", zeta);
    apply_setting(&dem_rolling_spring, l->settings, &w.pair, "stiffness", K);
    return l;
}

static void spring(void)
{
    struct rows_effect *l = row(0.1, 0.5, 0.0);
    const double k = 0.5*1e4*0.004*0.004;                 /* 0.08 N m */

    /* rounding */
    w.b.wx[0] = 300.0, w.b.wy[0] = -100.0, w.b.wz[0] = 1e4;
    moments_evaluate(&w, l);
    moments_evaluate(&w, l);
    TAP_NEAR(w.b.mx[0], -k*600e-6, 1e-17, "two steps of rolling load it against them");
    TAP_NEAR(w.b.my[0], k*200e-6, 1e-17, "in both rolling directions");
    TAP_OK(w.b.mz[0] == 0.0, "twist is not rolling");
    w.b.wx[0] = -600.0, w.b.wy[0] = 200.0;
    moments_evaluate(&w, l);
    TAP_NEAR(moments_size(&w), 0.0, 1e-17, "rolling back unloads it");

    l = row(0.1, 0.0, 0.0);
    w.b.wx[0] = 300.0;
    moments_evaluate(&w, l);
    TAP_NEAR(w.b.mx[0], -6.0*w.pair.reduced_shear/w.pair.reduced_modulus*1e4*1.6e-5*300e-6, 1e-17,
             "stiffness 0: k_t R^2, k_t/k_n = 6 G*/E*");

    l = row(0.1, 0.5, 0.3);
    w.b.wx[0] = 1.0;
    moments_evaluate(&w, l);
    TAP_NEAR(w.b.mx[0], -k*1e-6 - 2.0*0.3*sqrt(k*1.4*1e-3*1.6e-5), 1e-17,
             "with the dashpot of 2 zeta sqrt(k I)");
}

static void slip(void)
{
    struct rows_effect *const l = row(0.1, 0.5, 0.3);
    const double k = 0.08, c = 2.0*0.3*sqrt(k*1.4*1e-3*1.6e-5), limit = 0.1*0.004*10.0;

    w.b.wx[0] = 3e4, w.b.wy[0] = 4e4;
    moments_evaluate(&w, l);
    TAP_NEAR(moments_size(&w), limit, 1e-17, "mu_r R F_n, dashpot included");
    TAP_NEAR(w.b.mx[0], -0.6*limit, 1e-17, "against the rolling");
    /* round-off of a trial moment of 300 times the limit */
    TAP_NEAR(-(k + c/w.b.dt)*l->column[1][0], -0.8*limit, 1e-15, "spring and dashpot are cut in the same proportion");
    for (int n = 0; n < 20000; n++)                       /* c/k is 320 steps */
    {
        moments_evaluate(&w, l);
    }
    TAP_NEAR(-k*l->column[1][0], -0.8*limit, 1e-15,
             "slipping for long: the spring carries all of it");
    w.b.wx[0] = w.b.wy[0] = 0.0;
    moments_evaluate(&w, l);
    TAP_NEAR(moments_size(&w), limit, 1e-15, "when the slip stops: the moment is still at the limit");
    w.b.fn[0] = 5.0;
    moments_evaluate(&w, l);
    TAP_NEAR(moments_size(&w), 0.5*limit, 1e-15, "half the normal force: half the moment");
}

/* the line of centres rotates about y, `steps` of `step` radians; largest change of the spring's
   length, *lean along n, *back */
static double rotate_pair(int steps, double step, double *lean, double *back)
{
    struct rows_effect *const l = row(10.0, 0.5, 0.0);
    double worst = 0.0;

    w.b.fn[0] = 1e9;
    l->column[0][0] = 3e-6, l->column[1][0] = 4e-6;
    *lean = 0.0;
    for (int s = 1; s <= steps; s++)
    {
        w.b.nz[0] = cos(step*s), w.b.nx[0] = sin(step*s);
        w.b.hz[0] = cos(step*(s - 0.5)), w.b.hx[0] = sin(step*(s - 0.5));
        moments_evaluate(&w, l);
        const double x = l->column[0][0], y = l->column[1][0], z = l->column[2][0];

        worst = fmax(worst, fabs(sqrt(x*x + y*y + z*z)/5e-6 - 1.0));
        *lean = fmax(*lean, fabs(w.b.nx[0]*x + w.b.nz[0]*z)/5e-6);
    }
    *back = hypot(l->column[0][0] - 3e-6, l->column[1][0] - 4e-6)/5e-6;
    return worst;
}

static void rotation(void)
{
    double lean, back;

    /* 1e4 steps that round by 1e-16 */
    TAP_NEAR(rotate_pair(10000, 2.0*moments_pi/1000.0, &lean, &back), 0.0, 1e-12,
             "10 turns of the pair: the spring keeps its length");
    TAP_NEAR(lean, 0.0, 1e-15, "it lies in the contact plane");
    TAP_NEAR(back, 0.0, 1e-12, "after whole turns it is the same");
}

int main(void)
{
    TAP_TRAPS;
    spring();
    slip();
    rotation();
    moments_common(&w, &dem_rolling_spring, "friction", 0.1);
    TAP_DONE;
}
