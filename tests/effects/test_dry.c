/*
 * test_dry.c -- the dashpot of a coefficient of restitution: 1 gives no damping, 0 critical damping;
 * clamped it never attracts. Restitutions of impacts: physics/test_impact.c, test_bounce.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "law_rows.h"

static const struct dem_material oxide = {"aluminium oxide", 4000.0, 380e9, .poissons_ratio = 0.23};
static const struct dem_material rigid = {"rigid", 1.0, INFINITY, .poissons_ratio = 0.3};
static struct law_rows w;

static void row(double e, int attraction, double exponent, double vn, double *fn, double *eta)
{
    rows_wall(&w, &oxide, &rigid, 0.0025);
    rows_add(&w, &dem_hertz, "impactSpeed", 1.0);
    w.pair.exponent = exponent;
    struct rows_effect *const dry = rows_add(&w, &dem_dry, "restitution", e);
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
    TAP_DONE;
}
