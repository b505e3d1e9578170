/*
 * test_sjkr.c -- cohesion in proportion to the contact area.
 *
 * - The attraction is w times the area of the circle in which two spheres intersect.
 * - On a Hertzian contact under its cohesion alone the two forces are in equilibrium.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "law_rows.h"

static const struct dem_material glass = {"glass", 2500.0, 1e7, .poissons_ratio = 0.3};
static struct law_rows w;

int main(void)
{
    const double pi = 3.14159265358979324, density = 1e5, R = 5e-4;

    TAP_TRAPS;
    rows_spheres(&w, &glass, &glass, 1e-3, 1e-3);
    rows_add(&w, &dem_hooke, "stiffness", 1000.0);
    struct rows_effect *const l = rows_add(&w, &dem_sjkr, "energyDensity", density);

    /* two spheres of 1 mm, 1 um into each other: the circle of a sphere cut 0.5 um below its top */
    const double h = 0.5e-6, area = pi*h*(2.0*1e-3 - h);

    w.b.n = 1;
    w.b.overlap[0] = 2.0*h, w.b.reduced_radius[0] = R;
    w.b.fn[0] = 0.0;
    dem_sjkr.apply(l->settings, &w.b, l->history);
    TAP_NEAR(w.b.fn[0], -density*area, 1e-3*density*area,
             "w times the area of the circle");       /* first order in d/R = 2e-3 */

    /* 4/3 E* sqrt(R*) d^(3/2) = 2 pi w R* d */
    rows_spheres(&w, &glass, &glass, 1e-3, 1e-3);
    rows_add(&w, &dem_hertz, "impactSpeed", 1.0);
    rows_add(&w, &dem_sjkr, "energyDensity", density);
    const double root = 2.0*pi*density*R/rows_hertz(&w);

    w.b.n = 1;
    w.b.touching[0] = 1.0, w.b.overlap[0] = root*root, w.b.reduced_radius[0] = R;
    dem_hertz.apply(w.effect_entry[0].settings, &w.b, w.effect_entry[0].history);
    const double push = w.b.fn[0];

    dem_sjkr.apply(w.effect_entry[1].settings, &w.b, w.effect_entry[1].history);
    TAP_NEAR(w.b.fn[0], 0.0, 1e-14*push,
             "with hertz: equilibrium");    /* rounding */
    TAP_DONE;
}
