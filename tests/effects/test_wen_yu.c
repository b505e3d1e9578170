/*
 * test_wen_yu.c -- drag of Wen and Yu: tabulated values, Stokes' law for a single creeping sphere,
 * Newton's constant coefficient above Re = 1000, and the form and limits of all drag laws.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "drag_table.h"

static double G(double e, double re)
{
    return body_drag(&dem_wen_yu, NULL, e, re);
}

int main(void)
{
    static struct dem_body_batch b;
    static const double table[][3] = {                    /* e, Re, G: rounded to two places */
        {0.42, 1.0, 11.46}, {0.42, 200.0, 66.89}, {0.60, 20.0, 8.42}, {0.70, 200.0, 17.28},
        {0.80, 20.0, 3.93}, {0.90, 20.0, 2.88}, {0.99, 20.0, 2.23},
    };

    TAP_TRAPS;
    for (int k = 0; k < (int)(sizeof table/sizeof table[0]); k++)
    {
        TAP_NEAR(G(table[k][0], table[k][1]), table[k][2], 0.00501, "e = %g, Re = %g", table[k][0],
                 table[k][1]);
    }

    /* from here on: b and u of the test row are a few rounded factors, 1e-14 */
    TAP_NEAR(G(1.0, 0.0), 1.0, 1e-15, "a single creeping sphere: Stokes' 3 pi mu d");
    TAP_NEAR(G(1.0, 1e-6), 1.0, 1.2e-5, "at Re = 1e-6: 0.15 Re^0.687 is 1.13e-5");
    TAP_NEAR(G(0.5, 0.0), pow(0.5, -2.65), 1e-14, "at rest in a suspension: e^-2.65");
    TAP_NEAR(G(1.0, 1e5), 0.44*1e5/24.0, 1e-10, "Re = 1e5: Cd = 0.44");
    TAP_NEAR(G(1.0, 1000.1)/G(1.0, 999.9), 1.004, 1e-3,
             "the published step at Re = 1000 is 0.4 %%");
    drag_limits(&dem_wen_yu, NULL);
    drag_form(&dem_wen_yu, NULL);

    /* settling: with gravity and the pressure gradient of water at rest, a sphere of 1 um has no
       net force at Stokes' speed */
    const double d = 1e-6, excess = 1500.0, speed = excess*9.81*d*d/(18.0*1e-3);
    double down[3] = {0.0, 0.0, -9.81};

    memset(&b, 0, sizeof b);
    b.n = 1;
    body_fill(&b, 0, d, 1000.0, 1e-3, 1.0, 0.0);
    b.vz[0] = -speed;
    b.gz[0] = -9.81*1000.0;
    dem_gravity.apply_to_bodies(down, &b);
    dem_pressure_gradient.apply_to_bodies(NULL, &b);
    dem_effect_apply_to_bodies(&dem_wen_yu, NULL, &b);
    /* Re = 8e-7: the law is 1.0e-5 above Stokes' */
    TAP_NEAR((b.fz[0] - b.drag[0]*b.vz[0])/(excess*9.81*b.volume[0]), 0.0, 1.1e-5,
             "settles at Stokes' speed");
    TAP_DONE;
}
