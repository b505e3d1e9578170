/*
 * test_koch_hill.c -- drag of Hill, Koch and Ladd.
 *
 * Tabulated values; Stokes' drag for a single creeping sphere with its first correction 3
 * sqrt(s/2); Carman's 10 s/e^3 in dense suspensions; a step of 1 % at s = 0.4; the law uses half of
 * Re.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "drag_table.h"

static double G(double e, double re)
{
    return body_drag(&dem_koch_hill, NULL, e, re);
}

int main(void)
{
    TAP_TRAPS;
    drag_in_table(&dem_koch_hill, NULL, DRAG_KOCH_HILL);
    TAP_NEAR(G(1.0, 0.0), 1.0, 1e-15, "a single creeping sphere: Stokes' 3 pi mu d");
    /* next terms: 135/64 s ln s + (16.14 - 0.681 - 2) s = -1.6e-5 at s = 1e-6 */
    TAP_NEAR(G(1.0 - 1e-6, 0.0), 1.0 + 3.0*sqrt(0.5e-6), 2e-5,
             "dilute: 1 + 3 sqrt(s/2), Brinkman's");
    TAP_NEAR(G(0.45, 0.0), 10.0*0.55/0.45, 1e-13, "dense, at rest: e^2 10 s/e^3");    /* rounding */
    TAP_NEAR(G(0.6 - 1e-12, 0.0)/G(0.6 + 1e-12, 0.0), 18.5185/18.328, 2e-4,
             "the published step at s = 0.4");    /* 5 digits */
    /* F0 of the paper, evaluated in another program: a relative change of 1e-4 of any coefficient
       changes one of these values by more than 1e-6 of itself */
    static const double dilute[][2] = {{0.01, 1.2688166871125461}, {0.1, 2.8232292278019337},
                                       {0.2, 5.2160570565737086}, {0.3, 9.437280341726467},
                                       {0.39, 17.06028010040788}};

    for (int k = 0; k < 5; k++)
    {
        const double s = dilute[k][0], e = 1.0 - s;

        TAP_NEAR(G(e, 0.0)/(e*e*dilute[k][1]), 1.0, 1e-12, "at rest, s = %g: F0 = %.6g", s,
                 dilute[k][1]);
    }
    /* slope with Re; rounding of a difference, 1e-13 of 10 */
    TAP_NEAR((G(0.5, 100.0) - G(0.5, 0.0))/100.0, 0.25*0.5*(0.0673 + 0.106 + 0.0232*32.0),
             1e-12, "e^2 F3/2 on Re");
    drag_limits(&dem_koch_hill, NULL);
    drag_form(&dem_koch_hill, NULL);
    TAP_DONE;
}
