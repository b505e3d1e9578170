/*
 * Claims: the dashpot has the given coefficient; with a linear spring an impact of any speed returns exp(-pi z/sqrt(1 - z^2)),
 * z = c/(2 sqrt(k m)); clamped it never pulls, but leaves a pull of adhesion alone; the step limit is a fifth of m/c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "impacts.h"

static const struct dem_material glass = {"glass", 2500.0, 1e7, 0.3, 0.0};
static const double pi = 3.14159265358979324;
static struct impacts w;

static double impact(double k, double c, double v)
{
    impacts_wall(&w, &glass, &glass, 1e-3);
    const double dt = pi*sqrt(w.mass[0]/k)/4000;

    impacts_add(&w, &dem_hooke, "stiffness", k);
    impacts_add(&w, &dem_viscous, "coefficient", c);
    impacts_aim(&w, 16, dt, v);
    return impacts_impact(&w, dt, 80000) > 0 ? impacts_parting(&w)/v : NAN;
}

/* one row: spring force, normal speed; the sum, and eta */
static double row(double spring, double vn, int attraction, double *eta)
{
    impacts_wall(&w, &glass, &glass, 1e-3);
    w.pair.exponent = 1.0;
    struct impacts_effect *const l = impacts_add(&w, &dem_viscous, "coefficient", 2.0);

    settle(&dem_viscous, l->settings, &w.pair, "attraction", attraction);
    w.b.n = 2;
    w.b.touching[0] = 1.0;
    w.b.fn[0] = spring;
    w.b.vn[0] = w.b.vn[1] = vn;
    dem_viscous.apply(l->settings, &w.b, l->history);
    *eta = w.b.eta[0];
    TAP_OK(w.b.eta[1] == 0.0 && w.b.fn[1] == 0.0, "a row apart gets nothing");
    return w.b.fn[0];
}

int main(void)
{
    const double k = 500.0, m = ball(1e-3, 2500.0);
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
             "the speed does not matter");
    TAP_OK(row(1.0, -3.0, 0, &eta) == 7.0 && eta == 2.0, "pushes on approach");
    TAP_OK(row(1.0, 3.0, 0, &eta) == -5.0, "pulls at the end");
    TAP_OK(row(1.0, 3.0, 1, &eta) == 0.0 && eta == 2.0, "clamped, it does not");
    TAP_OK(row(1.0, -3.0, 1, &eta) == 7.0, "but pushes");
    TAP_OK(row(-1.0, 3.0, 1, &eta) == -7.0, "and what pulls by itself is not clamped");

    struct impacts_effect *const l = &w.effect_entry[0];

    TAP_NEAR(dem_viscous.time_limit(l->settings, &w.pair, &why), 0.1*m, 1e-15*m, "%s",
             why);    /* rounding */
    settle(&dem_viscous, l->settings, &w.pair, "coefficient", 0.0);
    TAP_OK(dem_viscous.time_limit(l->settings, &w.pair, &why) > 1e300, "no dashpot, no limit");
    TAP_OK(settle(&dem_viscous, l->settings, &w.pair, "coefficient", -1.0) == DEM_ERROR_INPUT, "%s",
           dem_error_text());
    w.pair.exponent = 0.0;
    TAP_OK(dem_viscous.prepare(l->settings, &w.pair) == DEM_ERROR_INPUT, "%s", dem_error_text());
    TAP_DONE;
}
