/*
 * test_viscous.c -- a dashpot of given coefficient.
 *
 * - With a linear spring an impact of any speed returns exp(-pi z/sqrt(1 - z^2)), z = c/(2 sqrt(k
 *   m)).
 * - Clamped it never attracts, but does not change the attraction of adhesion.
 * - The step limit is a fifth of m/c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "impacts.h"

static const struct dem_material glass = {"glass", 2500.0, 1e7, .poissons_ratio = 0.3};
static const double pi = 3.14159265358979324;
static struct impacts w;

static double impact(double k, double c, double v)
{
    impacts_wall(&w, &glass, &glass, 1e-3);
    const double dt = pi*sqrt(w.mass[0]/k)/4000;

    impacts_add(&w, &dem_hooke, "stiffness", k);
    impacts_add(&w, &dem_viscous, "coefficient", c);
    impacts_aim(&w, 16, dt, v);
    return impacts_impact(&w, dt, 80000) > 0 ? impacts_rebound_speed(&w)/v : NAN;
}

/* one row: spring force, normal speed; the sum, and eta */
static double row(double spring, double vn, int attraction, double *eta)
{
    impacts_wall(&w, &glass, &glass, 1e-3);
    w.pair.exponent = 1.0;
    struct impacts_effect *const l = impacts_add(&w, &dem_viscous, "coefficient", 2.0);

    apply_setting(&dem_viscous, l->settings, &w.pair, "attraction", attraction);
    w.b.n = 2;
    w.b.touching[0] = 1.0;
    w.b.fn[0] = spring;
    w.b.vn[0] = w.b.vn[1] = vn;
    dem_viscous.apply(l->settings, &w.b, l->history);
    *eta = w.b.eta[0];
    TAP_OK(w.b.eta[1] == 0.0 && w.b.fn[1] == 0.0, "a row apart has no force");
    return w.b.fn[0];
}

int main(void)
{
    const double k = 500.0, m = sphere_mass(1e-3, 2500.0);
    const char *why = "";
    double eta;

    TAP_TRAPS;
    for (double z = 0.05; z < 0.8; z *= 2.0)
    {
        const double e = exp(-pi*z/sqrt(1.0 - z*z));

        /* first order in the step with a dashpot: 1e-4 of 1 at t_c/4000, see test_dry */
        TAP_NEAR(impact(k, 2.0*z*sqrt(k*m), 0.3), e, 1e-4, "z = %g: e = %.4f", z, e);
    }
    TAP_NEAR(impact(k, 0.2*sqrt(k*m), 0.001), impact(k, 0.2*sqrt(k*m), 1.0), 1e-9,
             "restitution does not depend on the speed");
    TAP_OK(row(1.0, -3.0, 0, &eta) == 7.0 && eta == 2.0, "repels on approach");
    TAP_OK(row(1.0, 3.0, 0, &eta) == -5.0, "attracts at the end");
    TAP_OK(row(1.0, 3.0, 1, &eta) == 0.0 && eta == 2.0, "clamped: no attraction");
    TAP_OK(row(1.0, -3.0, 1, &eta) == 7.0, "clamped: repels on approach");
    TAP_OK(row(-1.0, 3.0, 1, &eta) == -7.0, "clamped: adhesion is not changed");

    struct impacts_effect *const l = &w.effect_entry[0];

    TAP_NEAR(dem_viscous.time_limit(l->settings, &w.pair, &why), 0.1*m, 1e-15*m, "%s",
             why);    /* rounding */
    apply_setting(&dem_viscous, l->settings, &w.pair, "coefficient", 0.0);
    TAP_OK(dem_viscous.time_limit(l->settings, &w.pair, &why) > 1e300, "no dashpot, no limit");
    TAP_OK(apply_setting(&dem_viscous, l->settings, &w.pair, "coefficient", -1.0) == DEM_ERROR_INPUT, "%s",
           dem_error_text());
    w.pair.exponent = 0.0;
    TAP_OK(dem_effect_prepare(&dem_viscous, l->settings, &w.pair) == DEM_ERROR_INPUT, "%s", dem_error_text());
    TAP_DONE;
}
