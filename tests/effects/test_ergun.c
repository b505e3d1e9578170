/*
 * test_ergun.c -- drag of Ergun.
 *
 * - In a fixed bed it gives Ergun's pressure drop, at any size, fluid and void fraction.
 * - It equals gidaspow's drag where gidaspow is switched and dense.
 * - For a single creeping sphere it vanishes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "drag_table.h"

static double G(double e, double re)
{
    return body_drag(&dem_ergun, NULL, e, re);
}

int main(void)
{
    /* column of CFDEM's Ergun test: superficial velocity, pressure drop, from another program (d =
       1 mm, e = 0.451335, 15.6 mm of bed, 10 kg/m3, 1.5e-3 Pa s) */
    static const double column[][2] = {{0.002, 22.99205}, {0.004, 45.997134}, {0.006, 69.015251}};
    static const double beds[][2] = {{0.35, 0.1}, {0.4, 5.0}, {0.45, 300.0}, {0.6, 2000.0}};
    const double pi = 3.14159265358979324;
    const int switched = 1;

    TAP_TRAPS;
    for (int k = 0; k < 4; k++)
    {
        const double e = beds[k][0], s = 1.0 - e, mu = 1e-3, rho = 1000.0, d = 1e-3,
                     U = beds[k][1]*mu/(rho*d);
        const double drop = s/sphere_volume(d)*(3.0*pi*mu*d*G(e, beds[k][1]))*(U/e)/e;
        const double published = 150.0*mu*s*s*U/(e*e*e*d*d) + 1.75*rho*s*U*U/(e*e*e*d);

        TAP_NEAR(drop/published, 1.0, 1e-13, "Ergun's pressure drop, e = %g, Re = %g", e,
                 beds[k][1]);    /* rounding */
        TAP_OK(G(e, beds[k][1]) == body_drag(&dem_gidaspow, &switched, e, beds[k][1]),
               "equal to gidaspow where that is dense");
    }
    for (int k = 0; k < 3; k++)
    {
        const double e = 0.451335, d = 1e-3, mu = 1.5e-3, U = column[k][0], re = 10.0*U*d/mu;
        const double drop = 0.0156*(1.0 - e)/sphere_volume(d)*(3.0*pi*mu*d*G(e, re))*(U/e)/e;

        TAP_NEAR(drop/column[k][1], 1.0, 1e-7, "15.6 mm of bed at %g m/s: %g Pa", U,
                 column[k][1]);    /* digits printed */
    }
    TAP_OK(G(1.0, 0.0) == 0.0, "a single creeping sphere: zero (a law for packings)");
    for (double e = 0.2; e < 0.999; e += 0.1)
    {
        TAP_OK(G(e, 0.0) > 0.0 && isfinite(G(e, 0.0)), "finite at rest, e = %g", e);
    }
    TAP_NEAR(G(0.1, 0.0), 150.0*0.8/(18.0*0.2), 1e-12, "below e = 0.2: Ergun's at 0.2");
    TAP_OK(G(0.1, 0.0) == G(0.2, 0.0) && G(1.1, 5.0) == G(1.0, 5.0*1.0/1.1), "beyond e = 0.2 to 1: as at the limits");
    drag_form(&dem_ergun, NULL);
    TAP_DONE;
}
