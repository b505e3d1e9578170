/*
 * test_rong.c -- drag of Rong, Dong and Yu.
 *
 * Tabulated values; 0.96 of Stokes' drag for a single creeping sphere; the exponent of the void
 * fraction that the paper gives at Re = 0 and Re = 10^1.5.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "drag_table.h"

static double G(double e, double re)
{
    return body_drag(&dem_rong, NULL, e, re);
}

int main(void)
{
    const double lone = 0.63*sqrt(pow(10.0, 1.5)) + 4.8;

    TAP_TRAPS;
    drag_in_table(&dem_rong, NULL, DRAG_RONG);
    /* rounding of logarithms and powers */
    TAP_NEAR(G(1.0, 0.0), 0.96, 1e-14, "a single creeping sphere: 4.8^2/24");
    TAP_NEAR(G(0.5, 0.0), 0.96*pow(0.5, 1.0 - 2.65*1.5), 1e-13, "at rest: chi = 2.65 (e + 1)");
    TAP_NEAR(G(0.5, pow(10.0, 1.5)),
             lone*lone/24.0*pow(0.5, 1.0 - (2.65*1.5 - (5.3 - 3.5*0.5)*0.25)), 1e-11,
             "at Re = 10^1.5: less by (5.3 - 3.5 e) e^2");
    TAP_NEAR(G(1.0, 50.0)/body_drag(&dem_di_felice, NULL, 1.0, 50.0), 1.0, 1e-14,
             "a single sphere: as diFelice");
    drag_limits(&dem_rong, NULL);
    drag_form(&dem_rong, NULL);
    TAP_DONE;
}
