/*
 * test_tenneti.c -- drag of Tenneti, Garg and Subramaniam.
 *
 * - Tabulated values; Stokes' drag for a single creeping sphere; the paper's formula.
 * - A creeping suspension agrees within 10 % with Beetstra's simulations, which it would not if the
 *   term of the single sphere were divided by e^2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "drag_table.h"

static double G(double e, double re)
{
    return body_drag(&dem_tenneti, NULL, e, re);
}

static double paper(double e, double re)
{
    const double s = 1.0 - e;

    return (1.0 + 0.15*pow(re, 0.687))/pow(e, 3) + 5.81*s/pow(e, 3) + 0.48*cbrt(s)/pow(e, 4)
         + pow(s, 3)*re*(0.95 + 0.61*pow(s, 3)/(e*e));
}

int main(void)
{
    double none[2] = {0.0, 0.0}, worst = 0.0, worst_hill = 0.0, worst_other = 0.0;

    TAP_TRAPS;
    drag_in_table(&dem_tenneti, NULL, DRAG_TENNETI);
    TAP_NEAR(G(1.0, 0.0), 1.0, 1e-15, "a single creeping sphere: Stokes' 3 pi mu d");
    /* 0.15 Re^0.687 */
    TAP_NEAR(G(1.0, 1e-6), 1.0, 1.2e-5, "a single sphere at Re = 1e-6");
    TAP_NEAR(G(1.0, 100.0), 1.0 + 0.15*pow(100.0, 0.687), 1e-12,
             "a single sphere: Schiller and Naumann's");    /* rounding */
    for (double e = 0.25; e < 1.0; e += 0.05)
    {
        for (double re = 1e-3; re < 1000.0; re *= 7.0)
        {
            /* rounding of powers */
            if (fabs(G(e, re)/(e*e*paper(e, re)) - 1.0) > 1e-13)
            {
                TAP_NEAR(G(e, re)/(e*e*paper(e, re)), 1.0, 1e-13,
                         "formula of the paper, e = %g, Re = %g", e, re);
            }
        }
    }
    TAP_OK(tap_count.failed == 0, "formula of the paper, e from 0.25 to 1, Re from 1e-3 to 1000");
    for (double s = 0.1; s < 0.505; s += 0.05)
    {
        const double e = 1.0 - s, beetstra = body_drag(&dem_beetstra, none, e, 0.0),
                     hill = body_drag(&dem_koch_hill, NULL, e, 0.0);
        const double other = G(e, 0.0) - 1.0/e + 1.0;

        worst = fmax(worst, fabs(G(e, 0.0)/beetstra - 1.0));
        worst_hill = fmax(worst_hill, fabs(G(e, 0.0)/hill - 1.0));
        worst_other = fmax(worst_other, fabs(other/beetstra - 1.0));
    }
    /* three sets of simulations; the two others differ by up to 7 % from each other */
    TAP_OK(worst < 0.10, "creeping, s from 0.1 to 0.5: within %.1f %% of Beetstra's", 100.0*worst);
    TAP_OK(worst_hill < 0.12, "creeping: within %.1f %% of Koch and Hill's", 100.0*worst_hill);
    TAP_OK(worst_other > 0.15, "with the single sphere's term over e^2 it would be %.1f %%",
           100.0*worst_other);
    drag_limits(&dem_tenneti, NULL);
    drag_form(&dem_tenneti, NULL);
    TAP_DONE;
}
