/*
 * test_gidaspow.c -- drag of Gidaspow.
 *
 * - Switched at e = 0.8: tabulated values; test_ergun.c has the pressure drop of packed beds.
 * - Smooth (Lu and Gidaspow 2003): continuous, halfway between both laws at e = 0.8 and near them
 *   outside.
 * - Finite at rest and beyond the range of e.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "drag_table.h"

static int blend;                                         /* the settings: 0 smooth, 1 switch */

static double G(double e, double re)
{
    return body_drag(&dem_gidaspow, &blend, e, re);
}

static double wen_yu(double e, double re)
{
    return body_drag(&dem_wen_yu, NULL, e, re);
}

static double ergun(double e, double re)
{
    return (150.0*(1.0 - e)/e + 1.75*re/e)/18.0;
}

static void switched(void)
{
    static const double table[][3] = {                    /* e, Re, G: rounded to two places */
        {0.42, 1.0, 11.74}, {0.42, 200.0, 57.80}, {0.60, 20.0, 8.80}, {0.70, 200.0, 31.35},
        {0.80, 20.0, 3.93}, {0.90, 20.0, 2.88}, {0.99, 20.0, 2.23},
    };

    blend = 1;
    for (int k = 0; k < (int)(sizeof table/sizeof table[0]); k++)
    {
        TAP_NEAR(G(table[k][0], table[k][1]), table[k][2], 0.00501, "e = %g, Re = %g", table[k][0],
                 table[k][1]);
    }
    TAP_NEAR(G(0.8 - 1e-12, 200.0), 26.4, 0.0501, "below the switch at Re = 200: Ergun, 26.4");
    TAP_NEAR(G(0.8, 200.0), 12.1, 0.0501, "at the switch: Wen and Yu, 12.1");
    TAP_NEAR(G(1.0, 0.0), 1.0, 1e-15, "a single creeping sphere: Stokes' 3 pi mu d");
}

/* phi to 1e-14: the series of atan is cut at 2e-17; a dozen roundings */
static void smooth(void)
{
    double worst = 0.0, step = 0.0;

    blend = 0;
    for (int k = 0; k <= 8000; k++)
    {
        const double e = 0.2 + 1e-4*k, s = 1.0 - e;
        const double phi = 0.5 + atan(150.0*1.75*(0.2 - s))/3.14159265358979324;
        const double expected = (1.0 - phi)*ergun(e, 200.0) + phi*wen_yu(e, 200.0);

        worst = fmax(worst, fabs(G(e, 200.0)/expected - 1.0));
        step = k ? fmax(step, fabs(G(e, 200.0)/G(e - 1e-4, 200.0) - 1.0)) : 0.0;
    }
    TAP_NEAR(worst, 0.0, 1e-13, "smooth: (1 - phi) Ergun + phi Wen-Yu over e = 0.2 to 1");
    TAP_OK(step < 0.01,
           "smooth: no jump, at most %.2g between void fractions 1e-4 apart, where the switch "
           "has 0.54",
           step);
    TAP_NEAR(G(0.8, 200.0), 0.5*(ergun(0.8, 200.0) + wen_yu(0.8, 200.0)), 1e-11,
             "smooth: halfway at e = 0.8");
    TAP_NEAR(G(0.4, 20.0)/ergun(0.4, 20.0), 1.0, 2e-3, "in a packed bed within 0.2 %% of Ergun");
    TAP_NEAR(G(1.0, 0.0), 1.0, 0.0061,
             "smooth: a single creeping sphere has 0.6 %% less than Stokes' drag");
}

int main(void)
{
    int settings;

    TAP_TRAPS;
    switched();
    smooth();
    for (blend = 0; blend < 2; blend++)
    {
        drag_form(&dem_gidaspow, &blend);
        TAP_OK(isfinite(G(0.4, 0.0)) && isfinite(G(0.9, 0.0)), "finite at rest");
        TAP_OK(G(0.1, 0.0) == G(0.2, 0.0) && G(1.2, 0.0) == G(1.0, 0.0),
               "beyond e = 0.2 and 1 as there");
    }
    dem_settings_set_defaults(dem_gidaspow.settings, &settings);
    TAP_OK(settings == 0, "smooth by default");
    TAP_OK(dem_settings_set_word(dem_gidaspow.settings, &settings, "gidaspow", "blend",
           "switch") == DEM_OK && settings == 1, "switch");
    TAP_DONE;
}
