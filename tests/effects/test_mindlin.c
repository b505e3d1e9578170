/*
 * test_mindlin.c -- friction with Mindlin's stiffness: a spring of 8 G* sqrt(R* d) that sticks, slides
 * at mu max(F_n, 0), rotates with the pair and stays in the contact plane. Impacts:
 * physics/test_chung_ooi.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tangential.h"

static struct law_rows w;

static void stiffness(void)
{
    struct rows_effect *l = tangential_row(&w, &dem_mindlin, 0.5, 0.0);
    const double kt = 8.0*w.pair.reduced_shear*sqrt(0.004*1e-6);

    w.b.sx[0] = 1e-3;
    tangential_evaluate(&w, l);
    /* a few rounded factors */
    TAP_NEAR(w.b.kt[0], kt, 1e-14*kt, "stiffness 8 G* sqrt(R* d)");
    w.b.eta[0] = 30.0;
    tangential_evaluate(&w, l);
    TAP_NEAR(w.b.fx[0], -kt*2e-9, 1e-14*kt*2e-9,
             "without tangential damping the coefficient of the normal law is not added");

    l = tangential_row(&w, &dem_mindlin, 0.0, 1.0);
    w.b.sx[0] = 3.0;
    w.b.eta[0] = 30.0;
    tangential_evaluate(&w, l);
    TAP_OK(tangential_size(&w) == 0.0 && l->column[0][0] == 0.0,
           "friction 0: no force, no elongation");
    w.b.sx[0] = 0.0;
    tangential_evaluate(&w, l);
    TAP_OK(tangential_size(&w) == 0.0, "friction 0 at rest: no force");
    w.pair.reduced_shear = 0.0;
    TAP_OK(dem_mindlin.prepare(l->settings, &w.pair) == DEM_ERROR_INPUT, "%s", dem_error_text());
}

/* ---- rotation of the spring --------------------------------------------------------------------- */

/*
 * The line of centres rotates about y by `step` radians a step (and its length oscillates by
 * `swing`); spring in both directions of the plane. Returns the largest change of its length;
 * *lean: of the component along n; *back: its change after whole turns, all over its length.
 */
static double rotate_pair(int steps, double step, double swing, double *lean, double *back)
{
    struct rows_effect *const l = tangential_row(&w, &dem_mindlin, 1.0, 0.0);
    double worst = 0.0, before[2] = {1.0, 0.0};

    w.b.fn[0] = 1e9;                                      /* sticks */
    l->column[0][0] = 3e-9, l->column[1][0] = 4e-9;
    *lean = 0.0;
    for (int s = 1; s <= steps; s++)
    {
        const double angle = step*s, length = 1.0 + swing*sin(2.0*tangential_pi*s/100.0);
        const double now[2] = {length*cos(angle),
                               length*sin(angle)};                /* z and x of the centre line */
        const double half[2] = {0.5*(now[0] + before[0]), 0.5*(now[1] + before[1])};
        const double n = sqrt(now[0]*now[0] + now[1]*now[1]),
                     h = sqrt(half[0]*half[0] + half[1]*half[1]);

        w.b.nz[0] = now[0]/n, w.b.nx[0] = now[1]/n;
        w.b.hz[0] = half[0]/h, w.b.hx[0] = half[1]/h;
        tangential_evaluate(&w, l);
        const double x = l->column[0][0], y = l->column[1][0], z = l->column[2][0];

        worst = fmax(worst, fabs(sqrt(x*x + y*y + z*z)/5e-9 - 1.0));
        *lean = fmax(*lean, fabs(w.b.nx[0]*x + w.b.nz[0]*z)/5e-9);
        before[0] = now[0], before[1] = now[1];
    }
    const double x = l->column[0][0] - 3e-9, y = l->column[1][0] - 4e-9, z = l->column[2][0];

    *back = sqrt(x*x + y*y + z*z)/5e-9;
    return worst;
}

static void rotation(void)
{
    double lean, back;
    const double fine = rotate_pair(10000, 2.0*tangential_pi/1000.0, 0.0, &lean, &back);

    /* each step rounds the length by about 1e-16, 1e4 steps in the worst case add up to 1e-12 */
    TAP_NEAR(fine, 0.0, 1e-12, "10 turns in 10000 steps: the spring keeps its length");
    TAP_NEAR(lean, 0.0, 1e-15,
             "it lies in the contact plane in every step");      /* by the last projection */
    TAP_NEAR(back, 0.0, 1e-12, "after whole turns it is the same");
    TAP_NEAR(rotate_pair(1000, 2.0*tangential_pi/10.0, 0.0, &lean, &back), 0.0, 1e-12,
             "steps of 36 degrees: no error of second order");
    TAP_NEAR(back, 0.0, 1e-12, "after whole turns it is the same");

    /* |r| oscillates by 1 % every 100 steps, 6e-4 a step: h deviates from the middle of the angle a
       = 6e-3 by up to a 6e-4/4, doubled by the reflection: 2e-6; half its square is lost in each of
       10000 steps: 2e-8 */
    TAP_NEAR(rotate_pair(10000, 2.0*tangential_pi/1000.0, 0.01, &lean, &back), 0.0, 2e-8,
             "oscillating distance: a second-order loss");
    TAP_NEAR(lean, 0.0, 1e-15, "oscillating distance: it stays in the plane");
}

int main(void)
{
    TAP_TRAPS;
    stiffness();
    tangential_claims(&w, &dem_mindlin);
    rotation();
    TAP_DONE;
}
