/*
 * test_linear.c -- the stiffness of the linear friction spring. Impacts: physics/test_chung_ooi.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tangential.h"

static struct law_rows w;

static void stiffness(void)
{
    struct rows_effect *l = tangential_row(&w, &dem_linear, 0.5, 0.0);

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

int main(void)
{
    TAP_TRAPS;
    stiffness();
    tangential_claims(&w, &dem_linear);
    TAP_DONE;
}
