/*
 * test_di_felice.c -- drag of Di Felice.
 *
 * - Tabulated values; 0.96 of Stokes' drag for a single creeping sphere.
 * - Exponent of the void fraction: 2.7 at small and large Re, 2.05 at Re = 10^1.5.
 * - Suspensions settle at the speeds of an independent balance.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "drag_table.h"

static double G(double e, double re)
{
    return body_drag(&dem_di_felice, NULL, e, re);
}

/* the exponent of e in G between 0.5 and 1 */
static double exponent(double re)
{
    return log(G(0.5, re)/G(1.0, re))/log(0.5);
}

int main(void)
{
    /* d, rho_p, rho, mu, e; settling speed e (u - v) from a bisection in another program */
    static const double suspension[][6] = {
        {1e-4, 2500, 1000, 1e-3, 0.9, 0.0044428321}, {1e-4, 2500, 1000, 1e-3, 0.5, 0.00031444833},
        {5e-4, 2500, 1000, 1e-3, 0.8, 0.035571297}, {1e-3, 2500, 1000, 1e-3, 0.6, 0.034357422},
        {3e-3, 2500, 1000, 1e-3, 0.95, 0.27105595}, {5e-5, 2000, 1.2, 1.8e-5, 0.7, 0.027522469},
    };
    const double pi = 3.14159265358979324;

    TAP_TRAPS;
    drag_in_table(&dem_di_felice, NULL, DRAG_DI_FELICE);
    /* rounding of logarithms and powers, 1e-14 of a few */
    TAP_NEAR(G(1.0, 0.0), 0.96, 1e-14, "a single creeping sphere: 4.8^2/24");
    TAP_NEAR(G(1.0, 1e-12), 0.96, 1e-5,
             "a single sphere at Re = 1e-12");          /* 2*0.63/4.8 sqrt Re = 2.6e-7 */
    TAP_NEAR(G(0.5, 0.0), 0.96*pow(0.5, -2.7), 1e-13, "at rest in a suspension: e^-2.7");
    TAP_NEAR(exponent(pow(10.0, 1.5)), -2.05, 1e-12, "e^-2.05 at Re = 10^1.5");
    /* exp(-5.5^2/2) = 2.7e-7 */
    TAP_NEAR(exponent(1e7), -2.7, 1e-6, "e^-2.7 at large Re");
    TAP_NEAR(G(1.0, 1e10)*24.0/1e10, 0.63*0.63, 1e-4,
             "Newton's regime: Cd = 0.3969");    /* 2*4.8*0.63/1e5 = 6e-5 */
    for (int k = 0; k < (int)(sizeof suspension/sizeof suspension[0]); k++)
    {
        const double d = suspension[k][0], rho = suspension[k][2], mu = suspension[k][3],
                     e = suspension[k][4], U = suspension[k][5];
        const double drag = 3.0*pi*mu*d*G(e, rho*U*d/mu)*U/e;

        /* drag of model A is e times the weight in the fluid: the rest is carried by the mixture's
           pressure gradient. Eight digits printed */
        TAP_NEAR(drag/(e*(suspension[k][1] - rho)*9.81*sphere_volume(d)), 1.0, 1e-7,
                 "d = %g, e = %g settles at %g m/s", d, e, U);
    }
    drag_limits(&dem_di_felice, NULL);
    drag_form(&dem_di_felice, NULL);
    TAP_DONE;
}
