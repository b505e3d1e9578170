/*
 * test_hoelzer_sommerfeld.c -- drag of Hoelzer and Sommerfeld.
 *
 * - A sphere: Cd = 24/Re + 3/sqrt Re + 0.42, Stokes' drag at rest; the power of the void fraction is
 *   diFelice's.
 * - A cube that falls on its face: phi = (pi/6)^(1/3) = 0.806, phi_c = pi d^2/4/a^2 = 1.209 and
 *   phi_l = pi d^2/4/(3 a^2 - 4/pi a^2) = 0.7002 (mean width of a square 4/pi a).
 *   Cd at Re = 100, 1e5 from these numbers by another program.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "drag_table.h"

static double G(double e, double re)
{
    return body_drag(&dem_hoelzer_sommerfeld, NULL, e, re);
}

/* Cd of a single particle */
static double cd(double re, double phi, double crosswise, double lengthwise)
{
    static struct dem_body_batch b;

    memset(&b, 0, sizeof b);
    b.n = 1;
    body_fill(&b, 0, 1e-3, 1000.0, 1e-3, 1.0, re);
    b.sphericity[0] = phi;
    b.crosswise[0] = crosswise;
    b.lengthwise[0] = lengthwise;
    dem_effect_apply_to_bodies(&dem_hoelzer_sommerfeld, NULL, &b);
    return b.drag[0]/(3.0*3.14159265358979324*1e-3*1e-3)*24.0/re;
}

int main(void)
{
    TAP_TRAPS;
    TAP_NEAR(G(1.0, 0.0), 1.0, 1e-14, "a creeping sphere: Stokes' drag");
    for (double re = 0.1; re < 2e5; re *= 10.0)
    {
        TAP_NEAR(G(1.0, re)*24.0/re/(24.0/re + 3.0/sqrt(re) + 0.42), 1.0, 1e-14, "a sphere at Re = %g", re);
        TAP_NEAR(G(0.4, re)/G(1.0, re)/(body_drag(&dem_di_felice, NULL, 0.4, re)/
                                        body_drag(&dem_di_felice, NULL, 1.0, re)),
                 1.0, 1e-13, "the factor of the void fraction is diFelice's at Re = %g", re);
    }
    TAP_NEAR(cd(100.0, 0.80599598, 1.20899397, 0.70015152), 1.24299102, 1e-8, "a cube on its face, Re = 100");
    TAP_NEAR(cd(1e5, 0.80599598, 1.20899397, 0.70015152), 0.62791808, 1e-8, "a cube on its face, Re = 1e5");
    drag_limits(&dem_hoelzer_sommerfeld, NULL);
    drag_form(&dem_hoelzer_sommerfeld, NULL);
    TAP_DONE;
}
