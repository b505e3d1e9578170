/*
 * test_schiller_naumann.c -- drag of a single sphere by Schiller and Naumann.
 *
 * - Stokes' law at small Re, Newton's above Re = 1000; equal to Wen and Yu's at void fraction 1.
 * - The void fraction enters only through the interstitial slip.
 * - Spheres settle at the speeds of an independent computation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "drag_table.h"

static double G(double e, double superficial_re)
{
    return body_drag(&dem_schiller_naumann, NULL, e, superficial_re);
}

int main(void)
{
    /* diameter, density; terminal speed, Re in water (1000 kg/m3, 1e-3 Pa s), from a bisection in
       another program */
    static const double settling[][4] = {
        {0.002, 1010.0, 0.010018023, 20.036047}, {0.002, 1050.0, 0.030770115, 61.54023},
        {0.002, 1200.0, 0.076043444, 152.08689}, {1e-4, 2500.0, 0.0072941035, 0.72941035},
        {0.001, 2500.0, 0.14594555, 145.94555}, {0.003, 2500.0, 0.36574954, 1097.2486},
    };

    TAP_TRAPS;
    TAP_NEAR(G(1.0, 0.0), 1.0, 1e-15, "at rest Stokes' 3 pi mu d");
    TAP_NEAR(G(1.0, 1e-6), 1.0, 1.2e-5, "at Re = 1e-6: 0.15 Re^0.687 is 1.13e-5");
    TAP_NEAR(G(1.0, 1e5), 0.44*1e5/24.0, 1e-10, "Re = 1e5: Cd = 0.44");
    TAP_NEAR(G(1.0, 1000.1)/G(1.0, 999.9), 1.004, 1e-3,
             "the published step at Re = 1000 is 0.4 %%");
    for (double re = 0.0; re < 1e4; re = 3.0*re + 1.0)
    {
        TAP_OK(G(1.0, re) == body_drag(&dem_wen_yu, NULL, 1.0, re),
               "Wen and Yu's for a single sphere, Re = %g", re);
        /* the superficial Re of a row at e = 0.4 is 0.4 times the law's Re; rounding of Re */
        TAP_NEAR(G(0.4, 0.4*re)/G(1.0, re), 1.0, 1e-14,
                 "the same in a suspension, with interstitial slip, Re = %g", re);
    }
    for (int k = 0; k < (int)(sizeof settling/sizeof settling[0]); k++)
    {
        const double d = settling[k][0], speed = settling[k][2],
                     weight = (settling[k][1] - 1000.0)*9.81*sphere_volume(d);

        /* eight digits printed */
        TAP_NEAR(3.0*3.14159265358979324*1e-3*d*G(1.0, settling[k][3])*speed/weight,
                 1.0, 3e-7, "d = %g m, %g kg/m3: drag is the weight in water at %g m/s", d,
                 settling[k][1], speed);
    }
    drag_limits(&dem_schiller_naumann, NULL);

    static struct dem_body_batch b;

    b.n = 3;
    body_fill(&b, 0, 1e-3, 1000.0, 1e-3, 0.6, 20.0);
    body_fill(&b, 1, 1e-3, 1000.0, 1e-3, 0.6, 20.0);
    b.vx[1] = -b.ux[1];
    dem_schiller_naumann.apply_to_bodies(NULL, &b);
    TAP_NEAR(b.drag[1]/(3.0*3.14159265358979324*1e-6), G(0.6, 40.0), 1e-13,
             "drag depends on the slip alone");    /* rounding */
    TAP_OK(b.drag_ux[0] == b.drag[0]*b.ux[0] && b.drag[2] == 0.0,
           "target with the coefficient; an empty row: zero");
    drag_form(&dem_schiller_naumann, NULL);
    TAP_DONE;
}
