/*
 * test_beetstra.c -- drag of Beetstra, van der Hoef and Kuipers has its tabulated values and
 * limits, and shares in a mixture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "drag_table.h"

/* the settings; 0: the diameter of each */
static struct { double mean_diameter; int around; } own;

static double G(double e, double re)
{
    return body_drag(&dem_beetstra, &own, e, re);
}

/* the paper's F, with its negative powers of Re */
static double paper(double e, double re)
{
    const double s = 1.0 - e;

    return 10.0*s/(e*e) + e*e*(1.0 + 1.5*sqrt(s)) +
           0.413*re/(24.0*e*e)*(1.0/e + 3.0*e*s + 8.4*pow(re, -0.343)) /
               (1.0 + pow(10.0, 3.0*s)*pow(re, -0.5*(1.0 + 4.0*s)));
}

/* three sizes in one fluid with one slip: the sum of their drags in a unit volume against the drag
   of spheres of the Sauter mean */
static void mixture(double e, double slip)
{
    static const double d[3] = {0.5e-3, 1e-3, 2e-3},
                        solids[3] = {0.2, 0.5, 0.3};    /* shares of the solid volume */
    static struct dem_body_batch b;
    double over = 0.0, sum = 0.0;

    for (int k = 0; k < 3; k++)
    {
        over += solids[k]/d[k];
    }
    own.mean_diameter = 1.0/over;
    memset(&b, 0, sizeof b);
    b.n = 4;
    for (int k = 0; k < 4; k++)
    {
        body_fill(&b, k, k < 3 ? d[k] : own.mean_diameter, 1000.0, 1e-3, e, 0.0);
        b.ux[k] = slip;
    }
    dem_beetstra.apply_to_bodies(&own, &b);
    for (int k = 0; k < 3; k++)
    {
        sum += solids[k]*(1.0 - e)/sphere_volume(d[k])*b.drag[k];
    }
    /* rounding */
    TAP_NEAR(sum/((1.0 - e)/sphere_volume(own.mean_diameter)*b.drag[3]), 1.0, 1e-13,
             "e = %g: as spheres of the Sauter mean", e);
    TAP_NEAR(b.drag[2]/b.drag[0], 16.0, 1e-12,
             "e = %g: four times the size, sixteen times the drag", e);
    const double alone = b.drag[3];

    own.mean_diameter = 0.0;
    body_fill(&b, 3, 1.0/over, 1000.0, 1e-3, e, 0.0);
    b.ux[3] = slip;
    dem_beetstra.apply_to_bodies(&own, &b);
    TAP_NEAR(b.drag[3]/alone, 1.0, 1e-15,    /* rounding of y = 1 */
             "e = %g: a sphere of the mean has the drag of equal spheres", e);
}

int main(void)
{
    TAP_TRAPS;
    own.mean_diameter = 0.0;
    drag_in_table(&dem_beetstra, &own, DRAG_BEETSTRA);
    TAP_NEAR(G(1.0, 0.0), 1.0, 1e-15, "a single creeping sphere: Stokes' 3 pi mu d");
    /* 0.145 Re^1.157 */
    TAP_NEAR(G(1.0, 1e-6), 1.0, 1e-5, "a single sphere at Re = 1e-6");
    TAP_NEAR(G(0.4, 0.0), 0.4*(10.0*0.6/0.16 + 0.16*(1.0 + 1.5*sqrt(0.6))), 1e-13,
             "a creeping packing");    /* rounding */
    for (double e = 0.25; e < 1.0; e += 0.07)
    {
        for (double re = 1e-3; re < 1e5; re *= 7.0)
        {
            /* rounding of powers */
            if (fabs(G(e, re)/(e*paper(e, re)) - 1.0) > 1e-13)
            {
                TAP_NEAR(G(e, re)/(e*paper(e, re)), 1.0, 1e-13,
                         "formula of the paper, e = %g, Re = %g", e, re);
            }
        }
    }
    TAP_OK(tap_count.failed == 0, "formula of the paper, e from 0.25 to 1, Re from 1e-3 to 1e5");
    mixture(0.45, 0.1);
    mixture(0.8, 0.01);
    mixture(0.99, 0.5);
    own.mean_diameter = 0.0;
    drag_limits(&dem_beetstra, &own);
    drag_form(&dem_beetstra, &own);

    /* the mean around each position */
    static struct dem_body_batch b;

    own.around = 1;
    memset(&b, 0, sizeof b);
    b.n = 3;
    for (int c = 0; c < 3; c++)
    {
        body_fill(&b, c, 1e-3, 1000.0, 1e-3, 0.5, 20.0);
    }
    b.mean_diameter[0] = 1e-3, b.mean_diameter[1] = 2e-3;
    dem_beetstra.apply_to_bodies(&own, &b);
    const double around = b.drag[1];

    TAP_NEAR(b.drag[0]/b.drag[2], 1.0, 1e-15,
             "a mean around equal to its diameter, or 0 for none: as among equals");
    own.around = 0, own.mean_diameter = 2e-3;
    body_fill(&b, 1, 1e-3, 1000.0, 1e-3, 0.5, 20.0);
    dem_beetstra.apply_to_bodies(&own, &b);
    TAP_OK(b.drag[1] == around, "the mean around gives the same as the setting");
    own.around = 1;
    TAP_OK(dem_beetstra.extra_needs(&own) == DEM_NEEDS_MEAN_DIAMETER &&
               dem_beetstra.prepare(&own, NULL) == DEM_ERROR_INPUT,
           "%s", dem_error_text());
    own.around = 0;
    TAP_OK(dem_beetstra.extra_needs(&own) == 0 && dem_beetstra.prepare(&own, NULL) == DEM_OK,
           "it needs the mean around only with that setting");

    double bad = -1e-3;

    dem_settings_set_defaults(dem_beetstra.settings, &own);
    TAP_OK(own.mean_diameter == 0.0 && own.around == 0, "default: the diameter of each");
    TAP_OK(dem_settings_set_number(dem_beetstra.settings, &own, "beetstra", "meanDiameter", &bad,
                                   1) == DEM_ERROR_INPUT,
           "%s", dem_error_text());
    TAP_DONE;
}
