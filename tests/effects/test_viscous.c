/*
 * test_viscous.c -- a dashpot of given coefficient.
 *
 * - The force is c v; impacts are in physics/test_bounce.c.
 * - Clamped it never attracts, but does not change the attraction of adhesion.
 * - The step limit is a fifth of m/c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "law_rows.h"

static const struct dem_material glass = {"glass", 2500.0, 1e7, .poissons_ratio = 0.3};
static struct law_rows w;

/* one row: spring force, normal speed; the sum, and eta */
static double row(double spring, double vn, int attraction, double *eta)
{
    rows_wall(&w, &glass, &glass, 1e-3);
    w.pair.exponent = 1.0;
    struct rows_effect *const l = rows_add(&w, &dem_viscous, "coefficient", 2.0);

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
    const double m = sphere_mass(1e-3, 2500.0);
    const char *why = "";
    double eta;

    TAP_TRAPS;
    TAP_OK(row(1.0, -3.0, 0, &eta) == 7.0 && eta == 2.0, "repels on approach");
    TAP_OK(row(1.0, 3.0, 0, &eta) == -5.0, "attracts at the end");
    TAP_OK(row(1.0, 3.0, 1, &eta) == 0.0 && eta == 2.0, "clamped: no attraction");
    TAP_OK(row(1.0, -3.0, 1, &eta) == 7.0, "clamped: repels on approach");
    TAP_OK(row(-1.0, 3.0, 1, &eta) == -7.0, "clamped: adhesion is not changed");

    struct rows_effect *const l = &w.effect_entry[0];

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
