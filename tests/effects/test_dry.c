/*
 * test_dry.c -- damping by a coefficient of restitution: with a Hertzian spring the restitution is the
 * one set, at any speed; 1 gives no damping, 0 critical damping; clamped it never attracts and has the
 * bias stated in its help. Linear springs are in test_hooke.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "impacts.h"

static const struct dem_material oxide = {"aluminium oxide", 4000.0, 380e9, .poissons_ratio = 0.23};
static const struct dem_material rigid = {"rigid", 1.0, INFINITY, .poissons_ratio = 0.3};
static struct impacts w;

/* aluminium oxide, 2.5 mm, on a rigid plane; mean over 16 phases */
static double bounce(double e, double speed, int clamped, int steps)
{
    impacts_wall(&w, &oxide, &rigid, 0.0025);
    const double dt = impacts_contact_time(&w, speed)/steps;

    impacts_add(&w, &dem_hertz, "impactSpeed", speed);
    struct impacts_effect *const dry = impacts_add(&w, &dem_dry, "restitution", e);
    apply_setting(&dem_dry, dry->settings, &w.pair, "attraction", clamped);
    impacts_aim(&w, 16, dt, speed);
    return impacts_impact(&w, dt, 20*steps) > 0 ? impacts_rebound_speed(&w)/speed : NAN;
}

/*
 * The dashpot sees the velocity of half a step before: m a = -k d - eta (v - a dt/2), as if the
 * mass were less by eta dt/2. So the restitution is too small by an error of order dt: halving the
 * step halves it. At t_c/400 that is 1e-4 down to e = 0.7 and 6e-4 at e = 0.2; a tenth of the step
 * leaves a tenth of it.
 */
static void restitution_as_set(void)
{
    static const double given[] = {0.05, 0.1, 0.2, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 1.0};

    for (int k = 0; k < (int)(sizeof given/sizeof given[0]); k++)
    {
        TAP_NEAR(bounce(given[k], 3.9, 0, 4000), given[k], 1e-4, "hertz, e = %g at t_c/4000",
                 given[k]);
    }
    const double a = bounce(0.5, 3.9, 0, 400) - 0.5, b = bounce(0.5, 3.9, 0, 800) - 0.5;

    TAP_NEAR(b/a, 0.5, 0.05, "half the step, half the error");
    TAP_NEAR(bounce(0.8, 0.01, 0, 400), bounce(0.8, 30.0, 0, 400), 1e-9,
             "restitution does not depend on the impact speed");
}

static void clamped(void)
{
    /* an independent integration of the clamped law, same particle and wall, 40000 steps a
       contact */
    static const double given[] = {0.2, 0.4, 0.5, 0.6, 0.8, 0.9};
    static const double found[] = {0.32485934, 0.47201187, 0.55028171,
                                   0.63228964, 0.80809925, 0.90202613};

    for (int k = 0; k < 6; k++)
    {
        /* the lag of half a step, at a tenth of the step */
        TAP_NEAR(bounce(given[k], 3.9, 1, 4000), found[k], 1e-4, "clamped, e = %g gives %.3f",
                 given[k], found[k]);
    }
}

static void row(double e, int attraction, double exponent, double vn, double *fn, double *eta)
{
    impacts_wall(&w, &oxide, &rigid, 0.0025);
    impacts_add(&w, &dem_hertz, "impactSpeed", 1.0);
    w.pair.exponent = exponent;
    struct impacts_effect *const dry = impacts_add(&w, &dem_dry, "restitution", e);
    apply_setting(&dem_dry, dry->settings, &w.pair, "attraction", attraction);
    w.b.n = 2;
    w.b.reduced_mass[0] = w.b.reduced_mass[1] = 0.01;
    /* the second row is apart: no stiffness */
    w.b.kn[0] = 1e6;
    w.b.fn[0] = 7.0;
    w.b.vn[0] = w.b.vn[1] = vn;
    w.b.fn[1] = 0.0;
    dem_dry.apply(dry->settings, &w.b, dry->history);
    *fn = w.b.fn[0];
    *eta = w.b.eta[0];
}

static void closed_forms(void)
{
    const double l = -log(0.3), beta0 = l/sqrt(l*l + 3.14159265358979324*3.14159265358979324);
    double fn, eta;

    /* sqrt(m* kn) = 100 kg/s; a handful of rounded factors */
    row(0.3, 0, 1.0, 0.5, &fn, &eta);
    TAP_NEAR(eta, 2.0*beta0*100.0, 1e-12, "linear: 2 beta sqrt(m k)");
    TAP_NEAR(fn, 7.0 - eta*0.5, 1e-12, "the force is less by eta vn, and may attract");
    TAP_OK(fn < 0.0, "here it attracts");
    TAP_OK(w.b.eta[1] == 0.0 && w.b.fn[1] == 0.0, "a row apart has no force");
    row(0.3, 1, 1.0, 0.5, &fn, &eta);
    TAP_OK(fn == 0.0, "clamped: it does not attract");
    w.b.fn[0] = -7.0;
    w.b.vn[0] = 0.5;
    dem_dry.apply(w.effect_entry[1].settings, &w.b, w.effect_entry[1].history);
    TAP_OK(w.b.fn[0] < -7.0, "clamped: attraction by adhesion is not changed");
    row(0.3, 0, 1.5, -0.5, &fn, &eta);
    TAP_NEAR(eta, sqrt(5.0)*beta0*100.0, 1e-12, "hertz: sqrt(5) beta sqrt(m k)");
    TAP_OK(fn > 7.0, "on approach it repels");
    row(0.3, 1, 1.5, -0.5, &fn, &eta);
    TAP_OK(fn > 7.0, "clamped: on approach it repels");
    row(1.0, 0, 1.5, 0.5, &fn, &eta);
    TAP_OK(eta == 0.0, "e = 1: no damping");
    row(0.0, 0, 1.0, 0.5, &fn, &eta);
    TAP_NEAR(eta, 200.0, 1e-12, "e = 0: critical damping: 2 sqrt(m k)");
    row(0.0, 0, 1.5, 0.5, &fn, &eta);
    TAP_NEAR(eta, sqrt(5.0)*100.0, 1e-12, "e = 0 with hertz: sqrt(5 m k)");
}

int main(void)
{
    TAP_TRAPS;
    closed_forms();
    restitution_as_set();
    clamped();
    TAP_DONE;
}
