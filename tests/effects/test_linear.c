/*
 * test_linear.c -- the linear friction spring has its stiffness, returns cos(pi sqrt(7 k_t/2 k_n))
 * of the slip where it sticks, and gives the oblique impacts of an independent integration.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tangential.h"

static struct impacts w;

static void stiffness(void)
{
    struct impacts_effect *l = tangential_row(&w, &dem_linear, 0.5, 0.0);

    w.b.sx[0] = 1e-3;
    tangential_evaluate(&w, l);
    TAP_NEAR(w.b.kt[0], 2e6/7.0, 1e-9, "2/7 of k_n by default");             /* rounding */
    apply_setting(&dem_linear, l->settings, &w.pair, "ratio", 0.5);
    tangential_evaluate(&w, l);
    TAP_OK(w.b.kt[0] == 5e5, "the ratio given");
    apply_setting(&dem_linear, l->settings, &w.pair, "stiffness", 1234.0);
    tangential_evaluate(&w, l);
    TAP_OK(w.b.kt[0] == 1234.0, "the stiffness given");

    const char *why = "";
    const double limit = 0.05*tangential_pi*sqrt(w.mass[0]/(3.5*1234.0));

    TAP_NEAR(dem_linear.time_limit(l->settings, &w.pair, &why), limit, 1e-14*limit, "%s",
             why);    /* rounding */
}

/* slip after over slip before of contacts that stick */
static void sticks(void)
{
    static const double ratio[] = {1.0/14.0, 0.2, 2.0/7.0, 0.5, 1.0, 8.0/7.0};
    const double k = 1e5, v = 0.5;

    for (int r = 0; r < 6; r++)
    {
        impacts_wall(&w, &tangential_oxide, &tangential_soda, 0.0025);
        const double dt = tangential_pi*sqrt(w.mass[0]/k)/4000.0;

        impacts_add(&w, &dem_hooke, "stiffness", k);
        struct impacts_effect *const l = impacts_add(&w, &dem_linear, "friction", 100.0);
        apply_setting(&dem_linear, l->settings, &w.pair, "ratio", ratio[r]);
        impacts_aim(&w, 16, dt, v);
        for (int c = 0; c < 16; c++)
        {
            w.v[0][0][c] = 0.1*v;
        }
        TAP_OK(impacts_impact(&w, dt, 8000) > 0, "separates");
        const double slip = (mean(w.v[0][0], 16) - 0.0025*mean(w.w[0][1], 16))/(0.1*v);

        /* the first and the last step of a contact are cut by half a step on average: pi sqrt(7/2
           ratio)/4000 */
        TAP_NEAR(slip, cos(tangential_pi*sqrt(3.5*ratio[r])), 2e-3,
                 "k_t/k_n = %.3f: %.4f of the slip is left", ratio[r], slip);
    }
}

static void oblique(void)
{
    /* angle, tangential restitution, spin: an independent integration with k_n = 1.72e7, k_t =
       1.48e7 N/m, 12000 steps */
    static const double table[][3] = {
        {2.0, 0.87512791, 16.996096}, {5.0, 0.80642468, 65.797683}, {10.0, 0.65181262, 235.80221},
        {15.0, 0.59409117, 409.72205}, {20.0, 0.59312186, 542.72603}, {25.0, 0.62171613, 623.49172},
        {30.0, 0.68130265, 621.45983}, {45.0, 0.816, 507.41983},      {60.0, 0.89376755, 358.8},
        {80.0, 0.96755584, 124.60993},
    };

    for (int t = 0; t < (int)(sizeof table/sizeof table[0]); t++)
    {
        double spin, energy;

        impacts_wall(&w, &tangential_oxide, &tangential_soda, 0.0025);
        const double dt = tangential_pi*sqrt(w.mass[0]/1.72e7)/4000.0;

        impacts_add(&w, &dem_hooke, "stiffness", 1.72e7);
        struct impacts_effect *const l = impacts_add(&w, &dem_linear, "friction", 0.092);
        apply_setting(&dem_linear, l->settings, &w.pair, "stiffness", 1.48e7);
        const double et = tangential_impact(&w, table[t][0], dt, 8000, &spin, &energy);

        /* whole steps at both ends of the contact: 1/4000 */
        TAP_NEAR(et, table[t][1], 5e-4, "%g degrees: tangential restitution %.4f", table[t][0],
                 table[t][1]);
        TAP_NEAR(spin, table[t][2], 0.1, "%g degrees: spin %.1f 1/s", table[t][0], table[t][2]);
        TAP_OK(energy <= 1.0 + 1e-5, "%g degrees: no energy gained, %.5f", table[t][0],
               energy);    /* (pi/4000)^2, leapfrog */
    }
}

int main(void)
{
    TAP_TRAPS;
    stiffness();
    tangential_claims(&w, &dem_linear);
    sticks();
    oblique();
    TAP_DONE;
}
