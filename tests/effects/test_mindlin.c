/*
 * test_mindlin.c -- friction with Mindlin's stiffness.
 *
 * - A sticking contact is a spring of 8 G* sqrt(R* d); a sliding one has |F_t| = mu max(F_n, 0) and
 *   never more.
 * - The friction impulse of a sliding impact is mu times the normal impulse; no step of slip gives
 *   energy.
 * - A sphere that slides towards +x on a plane below it starts to roll towards +x (spin about +y).
 * - The spring rotates with the pair, keeps its length and stays in the contact plane.
 * - Oblique impacts have known speeds and spins (Kharaz, Gorham, Salman, Powder Technol. 120 (2001)
 *   281).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tangential.h"

static const struct dem_material oxide = {"aluminium oxide", 4000.0, 380e9, .poissons_ratio = 0.23},
                                 soda = {"soda-lime glass", 2500.0, 70e9, .poissons_ratio = 0.25};
static const struct dem_material aluminium = {"aluminium", 2700.0, 70e9, .poissons_ratio = 0.33},
                                 rigid = {"rigid", 1.0, INFINITY, .poissons_ratio = 0.3};
static const double pi = 3.14159265358979324;
static struct impacts w;

/* ---- one row by hand ------------------------------------------------------------------------- */

/* a row at rest: normal z, R* = 4 mm, overlap 1 um, fn = 10 N */
static struct impacts_effect *row(double friction, double damping)
{
    impacts_wall(&w, &oxide, &soda, 0.004);
    w.pair.exponent = 1.5;
    struct impacts_effect *const l = impacts_add(&w, &dem_mindlin, "friction", friction);

    apply_setting(&dem_mindlin, l->settings, &w.pair, "tangentialDamping", damping);
    w.b.n = 1;
    w.b.dt = 1e-6;
    w.b.nz[0] = w.b.hz[0] = 1.0;
    w.b.touching[0] = 1.0;
    w.b.overlap[0] = 1e-6;
    w.b.reduced_radius[0] = 0.004;
    w.b.fn[0] = 10.0;
    return l;
}

static void evaluate(struct impacts_effect *l)
{
    w.b.fx[0] = w.b.fy[0] = w.b.fz[0] = 0.0;
    dem_mindlin.apply(l->settings, &w.b, l->history);
}

static double friction_force(void)
{
    return sqrt(w.b.fx[0]*w.b.fx[0] + w.b.fy[0]*w.b.fy[0] + w.b.fz[0]*w.b.fz[0]);
}

static void sticking(void)
{
    struct impacts_effect *l = row(0.5, 0.0);
    const double kt = 8.0*w.pair.reduced_shear*sqrt(0.004*1e-6);

    /* a few rounded factors: 1e-14 of the force */
    w.b.sx[0] = 2e-3, w.b.sy[0] = -1e-3;
    w.b.fn[0] = 1e3;
    evaluate(l);
    evaluate(l);
    TAP_NEAR(w.b.kt[0], kt, 1e-14*kt, "stiffness 8 G* sqrt(R* d)");
    TAP_NEAR(w.b.fx[0], -kt*4e-9, 1e-14*kt*4e-9, "two steps of slip load the spring against it");
    TAP_NEAR(w.b.fy[0], kt*2e-9, 1e-14*kt*2e-9, "in both tangential directions");
    w.b.sx[0] = -4e-3, w.b.sy[0] = 2e-3;
    evaluate(l);
    TAP_NEAR(friction_force(), 0.0, 1e-14*kt*4e-9, "slip back unloads it");

    l = row(0.5, 1.0);
    w.b.eta[0] = 30.0;
    w.b.sx[0] = 1e-3;
    evaluate(l);
    TAP_NEAR(w.b.fx[0], -kt*1e-9 - 30.0*1e-3, 1e-14,
             "with tangential damping the coefficient of the normal law is added");
    l = row(0.5, 0.0);
    w.b.eta[0] = 30.0;
    w.b.sx[0] = 1e-3;
    evaluate(l);
    TAP_NEAR(w.b.fx[0], -kt*1e-9, 1e-14*kt*1e-9, "without tangential damping it is not");
    w.b.sx[0] = 0.0;
    w.b.fn[0] = -1.0;
    evaluate(l);
    TAP_OK(friction_force() == 0.0 && l->column[0][0] == 0.0,
           "an attractive contact has no friction and no elongation");
}

static void sliding(void)
{
    struct impacts_effect *const l = row(0.5, 1.0);
    const double kt = 8.0*w.pair.reduced_shear*sqrt(0.004*1e-6);

    w.b.eta[0] = 30.0;
    w.b.sx[0] = 3.0, w.b.sy[0] = 4.0;
    evaluate(l);
    TAP_NEAR(friction_force(), 5.0, 5e-15, "sliding: mu fn");
    TAP_NEAR(w.b.fx[0], -3.0, 5e-15, "against the slip");
    /* round-off of a trial force of 33 times the limit */
    TAP_NEAR(-(kt + 30.0/w.b.dt)*l->column[1][0], -4.0, 1e-13,
             "spring and dashpot are cut in the same proportion");
    for (int k = 0; k < 500; k++)                         /* c/k is 5 steps */
    {
        evaluate(l);
    }
    TAP_NEAR(-kt*l->column[1][0], -4.0, 1e-13,
             "sliding for long: the spring carries all of it");
    w.b.sx[0] = w.b.sy[0] = 0.0;
    evaluate(l);
    TAP_NEAR(friction_force(), 5.0, 1e-13, "when the slip stops: the force is still mu fn");
    w.b.sx[0] = -1e-3;
    evaluate(l);
    TAP_OK(friction_force() < 5.0 && w.b.fx[0] < 0.0,
           "a small slip back unloads; the force does not reverse at once");
}

static void apart(void)
{
    struct impacts_effect *const l = row(0.5, 1.0);

    w.b.touching[0] = w.b.overlap[0] = w.b.fn[0] = 0.0;
    w.b.sx[0] = 3.0;
    l->column[0][0] = 1e-6;
    evaluate(l);
    TAP_OK(friction_force() == 0.0 && w.b.kt[0] == 0.0 && l->column[0][0] == 0.0,
           "a row apart has no force and no elongation");

    struct impacts_effect *const smooth = row(0.0, 1.0);

    w.b.sx[0] = 3.0;
    w.b.eta[0] = 30.0;
    evaluate(smooth);
    TAP_OK(friction_force() == 0.0 && smooth->column[0][0] == 0.0,
           "friction 0: no force, no elongation");
    w.b.sx[0] = 0.0;
    evaluate(smooth);
    TAP_OK(friction_force() == 0.0, "friction 0 at rest: no force");
    TAP_OK(apply_setting(&dem_mindlin, l->settings, &w.pair, "friction", -0.1) == DEM_ERROR_INPUT,
           "%s", dem_error_text());
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
    struct impacts_effect *const l = row(1.0, 0.0);
    double worst = 0.0, before[2] = {1.0, 0.0};

    w.b.fn[0] = 1e9;                                      /* sticks */
    l->column[0][0] = 3e-9, l->column[1][0] = 4e-9;
    *lean = 0.0;
    for (int s = 1; s <= steps; s++)
    {
        const double angle = step*s, length = 1.0 + swing*sin(2.0*pi*s/100.0);
        const double now[2] = {length*cos(angle),
                               length*sin(angle)};                /* z and x of the centre line */
        const double half[2] = {0.5*(now[0] + before[0]), 0.5*(now[1] + before[1])};
        const double n = sqrt(now[0]*now[0] + now[1]*now[1]),
                     h = sqrt(half[0]*half[0] + half[1]*half[1]);

        w.b.nz[0] = now[0]/n, w.b.nx[0] = now[1]/n;
        w.b.hz[0] = half[0]/h, w.b.hx[0] = half[1]/h;
        evaluate(l);
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
    const double fine = rotate_pair(10000, 2.0*pi/1000.0, 0.0, &lean, &back);

    /* each step rounds the length by about 1e-16, 1e4 steps in the worst case add up to 1e-12 */
    TAP_NEAR(fine, 0.0, 1e-12, "10 turns in 10000 steps: the spring keeps its length");
    TAP_NEAR(lean, 0.0, 1e-15,
             "it lies in the contact plane in every step");      /* by the last projection */
    TAP_NEAR(back, 0.0, 1e-12, "after whole turns it is the same");
    TAP_NEAR(rotate_pair(1000, 2.0*pi/10.0, 0.0, &lean, &back), 0.0, 1e-12,
             "steps of 36 degrees: no error of second order");
    TAP_NEAR(back, 0.0, 1e-12, "after whole turns it is the same");

    /* |r| oscillates by 1 % every 100 steps, 6e-4 a step: h deviates from the middle of the angle a
       = 6e-3 by up to a 6e-4/4, doubled by the reflection: 2e-6; half its square is lost in each of
       10000 steps: 2e-8 */
    TAP_NEAR(rotate_pair(10000, 2.0*pi/1000.0, 0.01, &lean, &back), 0.0, 2e-8,
             "oscillating distance: a second-order loss");
    TAP_NEAR(lean, 0.0, 1e-15, "oscillating distance: it stays in the plane");
}

/* the same row in randomly rotated axes gives the same force, rotated */
static void axes(void)
{
    const double s = sin(0.7), c = cos(0.7), t = sin(1.9), u = cos(1.9);
    const double turned[3][3] = {{c, -s*u, s*t}, {s, c*u, -c*t}, {0.0, t, u}};
    const double v[4][3] = {{0.6, 0.0, 0.8},
                            {0.64, 0.02, 0.76},
                            {3e-9, 1e-9, -2e-9},
                            {1e-3, -2e-3, 0.5e-3}};
    double force[2][3];

    for (int pass = 0; pass < 2; pass++)
    {
        double a[4][3];
        struct impacts_effect *const l = row(0.5, 1.0);

        for (int k = 0; k < 4; k++)
        {
            for (int d = 0; d < 3; d++)
            {
                a[k][d] = pass ? dot(turned[d], v[k]) : v[k][d];
            }
        }
        w.b.nx[0] = a[0][0], w.b.ny[0] = a[0][1], w.b.nz[0] = a[0][2];
        w.b.hx[0] = a[1][0], w.b.hy[0] = a[1][1], w.b.hz[0] = a[1][2];
        l->column[0][0] = a[2][0], l->column[1][0] = a[2][1], l->column[2][0] = a[2][2];
        w.b.sx[0] = a[3][0], w.b.sy[0] = a[3][1], w.b.sz[0] = a[3][2];
        w.b.eta[0] = 30.0;
        evaluate(l);
        force[pass][0] = w.b.fx[0], force[pass][1] = w.b.fy[0], force[pass][2] = w.b.fz[0];
        TAP_NEAR(dot(force[pass], a[0]), 0.0, 1e-15, "the force has no component along the normal");
    }
    for (int d = 0; d < 3; d++)
    {
        TAP_NEAR(force[1][d], dot(turned[d], force[0]), 1e-15,
                 "rotated axes, component %d of %g N", d, force[1][d]);
    }
}

/* ---- impacts --------------------------------------------------------------------------------- */

static void impact(double friction, double e, int clamped, double vn, double vt, double spin_y,
                   int steps)
{
    const double dt = impacts_contact_time(&w, vn)/steps;

    impacts_add(&w, &dem_hertz, "impactSpeed", vn);
    struct impacts_effect *const dry = impacts_add(&w, &dem_dry, "restitution", e);
    apply_setting(&dem_dry, dry->settings, &w.pair, "attraction", clamped);
    impacts_add(&w, &dem_mindlin, "friction", friction);
    w.friction = friction;
    impacts_aim(&w, 16, dt, vn);
    for (int c = 0; c < 16; c++)
    {
        w.v[0][0][c] = vt;
        w.w[0][1][c] = spin_y;
        w.w[1][1][c] = w.mass[1] > 0.0 ? spin_y : 0.0;
    }
    TAP_OK(impacts_impact(&w, dt, 20*steps) > 0, "separates");
    /* |F| may be rounded up by two units in the last place of 1e4 N */
    TAP_NEAR(fmax(w.worst_friction, 0.0), 0.0, 1e-11, "friction was never above mu max(fn, 0)");
}

static double row_mean(double *column)
{
    return mean(column, 16);
}

static double ratio(double friction)
{
    double sum = 0.0;

    for (int c = 0; c < 16; c++)
    {
        sum += w.friction_impulse[c]/(friction*w.normal_impulse[c])/16.0;
    }
    return sum;
}

static void signs(void)
{
    impacts_wall(&w, &oxide, &soda, 0.0025);
    impact(0.3, 0.9, 0, 1.0, 2.0, 0.0, 400);
    TAP_OK(row_mean(w.v[0][0]) < 2.0 && row_mean(w.v[0][0]) > 0.0,
           "a sphere sliding to +x on the plane below it slows down");
    TAP_OK(row_mean(w.w[0][1]) > 0.0, "it starts to roll to +x: spin about +y, %g 1/s",
           row_mean(w.w[0][1]));
    /* an impulse at the contact point changes R w by 5/2 of the change of speed, whatever its
       history: rounding only */
    TAP_NEAR(row_mean(w.w[0][1])*0.0025, 2.5*(2.0 - row_mean(w.v[0][0])), 1e-12,
             "R w = 5/2 of the speed lost");
    TAP_OK(row_mean(w.v[0][1]) == 0.0 && row_mean(w.w[0][0]) == 0.0 && row_mean(w.w[0][2]) == 0.0,
           "no velocity across");

    impacts_spheres(&w, &aluminium, &aluminium, 0.1, 0.1);
    impact(0.4, 0.5, 0, 0.4, 0.0, 8.0, 400);
    TAP_OK(row_mean(w.w[0][1]) < 8.0 && row_mean(w.w[1][1]) < 8.0,
           "two spheres of like spin: both slow down");
    TAP_NEAR(row_mean(w.w[0][1]), row_mean(w.w[1][1]), 1e-12,
             "two spheres of like spin: equal changes");
    /* i lies above j; its lowest point moves to -x, so friction on it is to +x: w = 5/2 impulse/(m
       R) */
    /* meanwhile the line of centres rotates by some 1e-4, and that fraction of the normal impulse
       acts across, too */
    TAP_NEAR(row_mean(w.v[0][0])*2.5/0.1, 8.0 - row_mean(w.w[0][1]), 2e-3,
             "velocity across by the same impulse");
}

/* full sliding: the impulse is Coulomb's, up to the steps that stick at first contact */
static void full_sliding(void)
{
    static const double x[] =
        /* 7/2 mu (1 + e) v_n over the slip speed; < 1: slides */
        {0.18372619, 0.76433749};
    static const double spin_back[] = {-0.80983243, -0.21039119};

    for (int k = 0; k < 2; k++)
    {
        for (int clamped = 0; clamped < 2; clamped++)
        {
            impacts_wall(&w, &aluminium, &rigid, 0.1);
            const double slip = 3.5*0.4*1.5*0.2/x[k];

            impact(0.4, 0.5, clamped, 0.2, 0.0, -slip/0.1, 4000);
            TAP_NEAR(ratio(0.4), 1.0, 1e-4,
                     "x = %.2f, %s: the friction impulse is mu times the normal one", x[k],
                     clamped ? "clamped" : "with attraction");
            if (clamped)
            {
                /* an independent integration of the clamped law: -slip after over slip before */
                const double after = row_mean(w.v[0][0]) - 0.1*row_mean(w.w[0][1]);

                TAP_NEAR(-after/slip, spin_back[k], 1e-3, "x = %.2f: slip after the impact", x[k]);
            }
        }
    }
    impacts_wall(&w, &oxide, &soda, 0.0025);
    impact(0.092, 1.0, 0, 3.9*cos(pi/3.0), 3.9*sin(pi/3.0), 0.0, 400);
    const double vn = 3.9*cos(pi/3.0), vt = 3.9*sin(pi/3.0);

    /* rigid-body result with Coulomb friction, e = 1; the elastic impact keeps its speed within
       1e-6 at this step, and the first step of each row may stick: 1/400 of the force of the first
       instant, 1e-5 of the impulse */
    TAP_NEAR(row_mean(w.v[0][0]), vt - 0.092*2.0*vn, 1e-4*vt,
             "60 degrees, tangential speed of the rigid sphere");
    TAP_NEAR(row_mean(w.w[0][1]), 2.5*0.092*2.0*vn/0.0025, 0.04,
             "60 degrees, spin of the rigid sphere");
}

/* opposite equal spins: the surfaces roll on each other and the spins do not change */
static void matching_spins(void)
{
    impacts_spheres(&w, &aluminium, &aluminium, 0.1, 0.1);
    const double dt = impacts_contact_time(&w, 0.4)/400.0;

    impacts_add(&w, &dem_hertz, "impactSpeed", 0.4);
    impacts_add(&w, &dem_dry, "restitution", 0.5);
    impacts_add(&w, &dem_mindlin, "friction", 0.4);
    impacts_aim(&w, 16, dt, 0.4);
    for (int c = 0; c < 16; c++)
    {
        w.w[0][1][c] = 20.0, w.w[1][1][c] = -20.0;
    }
    TAP_OK(impacts_impact(&w, dt, 4000) > 0, "separates");
    TAP_OK(row_mean(w.w[0][1]) == 20.0 && row_mean(w.w[1][1]) == -20.0 &&
               row_mean(w.v[0][0]) == 0.0,
           "matching spins do not change");
}

/*
 * Angle from the normal, tangential restitution, spin: an independent integration of the same law
 * with 12000 steps. Near the normal the secant law returns more tangential speed than before, and a
 * spin of the opposite sign.
 */
static const double kharaz[][3] = {
    {2.0, 1.0006378, -0.086806086}, {5.0, 0.94875088, 17.419954}, {10.0, 0.69698558, 205.20981},
    {15.0, 0.62856072, 374.92869},  {20.0, 0.61848406, 508.89593}, {25.0, 0.63613519, 599.72606},
    {30.0, 0.68130265, 621.45983}, {35.0, 0.73722077, 587.82351}, {45.0, 0.816, 507.41983},
    {60.0, 0.89376755, 358.8}, {80.0, 0.96755584, 124.60993},
};

static void oblique(void)
{
    for (int k = 0; k < (int)(sizeof kharaz/sizeof kharaz[0]); k++)
    {
        const double angle = kharaz[k][0]*pi/180.0, vn = 3.9*cos(angle), vt = 3.9*sin(angle);

        impacts_wall(&w, &oxide, &soda, 0.0025);
        impact(0.092, 1.0, 0, vn, vt, 0.0, 4000);
        /* the first step loads the spring with its whole slip however late in it contact began:
           half a step in 4000 on average, relevant only where the contact sticks from the start (2
           degrees: 5e-5 of the speed, 0.006 1/s) */
        TAP_NEAR(row_mean(w.v[0][0])/vt, kharaz[k][1], 2e-4,
                 "%g degrees: tangential restitution %.4f", kharaz[k][0], kharaz[k][1]);
        TAP_NEAR(row_mean(w.w[0][1]), kharaz[k][2], 0.02, "%g degrees: spin %.1f 1/s", kharaz[k][0],
                 kharaz[k][2]);
    }
}

int main(void)
{
    TAP_TRAPS;
    sticking();
    sliding();
    tangential_energy(&w, &dem_mindlin);
    apart();
    rotation();
    axes();
    signs();
    full_sliding();
    matching_spins();
    oblique();
    TAP_DONE;
}
