/*
 * test_mindlin_incremental.c -- incremental friction keeps its force under compression, loses
 * energy in cycles in which mindlin gains. Impacts: physics/test_chung_ooi.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tangential.h"

static struct law_rows w;

/* one step at this overlap and slip; the force */
static double step(struct rows_effect *l, double overlap, double slip)
{
    w.b.overlap[0] = overlap;
    w.b.sx[0] = slip/1e-6;
    tangential_evaluate(&w, l);
    return w.b.fx[0];
}

static void pressing(void)
{
    struct rows_effect *const l = tangential_row(&w, &dem_mindlin_incremental, 100.0, 0.0);
    const double k = 8.0*w.pair.reduced_shear*sqrt(0.004*1e-6);

    /* a few rounded factors */
    TAP_NEAR(step(l, 1e-6, 1e-9), -k*1e-9, 1e-13*k*1e-9, "8 G* sqrt(R* d) times the slip");
    TAP_NEAR(step(l, 4e-6, 0.0), -k*1e-9, 1e-13*k*1e-9,
             "compressed four times as far: the force does not change");
    TAP_NEAR(step(l, 4e-6, 1e-9), -3.0*k*1e-9, 1e-13*k*1e-9,
             "more slip loads with the new stiffness, twice the old");
    TAP_NEAR(step(l, 1e-6, 0.0), -1.5*k*1e-9, 1e-13*k*1e-9, "half separated: half the force");
    TAP_NEAR(step(l, 1e-6, -1.5e-9), 0.0, 1e-13*k*1e-9, "slip back by the remaining elongation unloads it");
}

/* work done on the contact in cycles of slip at a small overlap, compression, slip back,
   decompression */
static double cycle(const struct dem_effect *law)
{
    struct rows_effect *const l = tangential_row(&w, law, 1e2, 0.0);
    double work = 0.0, before = 0.0;

    w.b.fn[0] = 1e9;                                      /* sticks */
    for (int s = 0; s < 40; s++)
    {
        for (int k = 0; k < 400; k++)
        {
            const double part = (k % 100 + 1)/100.0, deep = k < 100 ? 0.0
                                                              : k < 200 ? part
                                                              : k < 300 ? 1.0
                                                                        : 1.0 - part;
            const double slip = k < 100 ? 1e-11 : k >= 200 && k < 300 ? -1e-11 : 0.0;
            const double force = step(l, 1e-6 + 3e-6*deep, slip);

            work -= 0.5*(before + force)*slip;
            before = force;
        }
    }
    return work/(8.0*w.pair.reduced_shear*sqrt(0.004*1e-6)*1e-18);
}

static void cycles(void)
{
    /* in units of k l^2, k at the small overlap: each cycle of mindlin gives (2 - 1)/2 */
    TAP_NEAR(cycle(&dem_mindlin), -20.0, 1.0,
             "forty cycles of slip and compression: mindlin gains energy");    /* steps of 1/100 */
    TAP_OK(cycle(&dem_mindlin_incremental) > 0.0, "forty cycles: mindlinIncremental loses energy, %g",
           cycle(&dem_mindlin_incremental));
}

int main(void)
{
    TAP_TRAPS;
    pressing();
    tangential_claims(&w, &dem_mindlin_incremental);
    cycles();

    struct rows_effect *const l = tangential_row(&w, &dem_mindlin_incremental, 0.5, 0.0);

    w.pair.reduced_shear = 0.0;
    TAP_OK(dem_mindlin_incremental.prepare(l->settings, &w.pair) == DEM_ERROR_INPUT, "%s",
           dem_error_text());
    TAP_DONE;
}
