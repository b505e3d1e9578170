/*
 * test_refinement_series.c -- evaluation of a refinement series.
 *
 * - A smooth series returns the value, the order and the errors it was made from.
 * - Where the scatter is a property of the scene, the 95 % interval contains the true value in 95
 *   of 100 series.
 * - Where the means do not converge, no value is claimed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "unit/tap.h"

#include "core/random.h"
#include "advisor/refinement_series.h"

#include <math.h>
#include <string.h>

static const double truth = 3.0;

/* uniform in -1 to 1 */
static double random_number(uint64_t series, uint64_t number)
{
    return 2.0*dem_random_unit(7, series, number, 0) - 1.0;
}

/* value = truth + c h^p + phase h x + own y, x and y random */
struct made
{
    double c, p, phase, own;
    int runs, levels;
};

static struct dem_refinement_series make(const struct made *m, uint64_t number)
{
    struct dem_refinement_series l;
    uint64_t k = 0;

    memset(&l, 0, sizeof l);
    l.levels = m->levels;
    for (int r = 0; r < m->levels; r++)
    {
        const double h = 2.0/(1 << r);

        l.level[r] = (struct dem_refinement_level){.size = h, .runs = m->runs};
        for (int n = 0; n < m->runs; n++)
        {
            l.level[r].value[n] = truth + m->c*pow(h, m->p) + m->phase*h*random_number(number, k) +
                                  m->own*random_number(number, k + 1);
            k += 2;
        }
    }
    dem_refinement_evaluate(&l);
    return l;
}

static void smooth(void)
{
    for (double p = 1.0; p < 3.0; p += 0.5)
    {
        const struct dem_refinement_series l =
            make(&(struct made){.c = 0.2, .p = p, .runs = 3, .levels = 5}, 0);

        TAP_OK(l.kind == DEM_REFINEMENT_EXTRAPOLATED, "a smooth series is extrapolated");
        /* round-off */
        TAP_NEAR(l.reference, truth, 1e-12, "smooth: the true value");
        TAP_NEAR(l.order, p, 1e-9, "smooth: the order");
        TAP_NEAR(l.level[0].error, 0.2*pow(2.0, p), 1e-12, "smooth: the errors");
        TAP_OK(l.uncertainty < 1e-12 && l.order_uncertainty < 1e-9,
               "smooth: the uncertainty is zero");
    }
}

/* 0.2 h and a random scatter of 0.05 h: the stated interval must nearly always contain the true
   value */
static void scattered(void)
{
    int held = 0, extrapolated = 0;

    for (uint64_t k = 0; k < 400; k++)
    {
        const struct dem_refinement_series l =
            make(&(struct made){.c = 0.2, .p = 1.0, .phase = 0.05, .runs = 5, .levels = 5}, k);

        held += fabs(l.reference - truth) <= l.uncertainty;
        extrapolated += l.kind == DEM_REFINEMENT_EXTRAPOLATED;
    }
    TAP_OK(extrapolated >= 390,
           "scatter that decreases with the step is due to the step: %d of 400", extrapolated);
    /* 95 % */
    TAP_OK(held >= 380, "the true value is within the uncertainty in %d of 400", held);
}

static void chaotic(void)
{
    int held = 0, statistics = 0, exact = 0;

    for (uint64_t k = 0; k < 400; k++)
    {
        const struct dem_refinement_series l =
            make(&(struct made){.own = 0.1, .runs = 5, .levels = 5}, 1000 + k);

        statistics += l.kind == DEM_REFINEMENT_STATISTICS;
        held += fabs(l.reference - truth) <= l.uncertainty;
        exact += l.level[1].error <= l.level[1].uncertainty;
    }
    TAP_OK(statistics >= 380, "scatter that stays is a property of the scene: %d of 400",
           statistics);
    TAP_OK(held >= 368, "the true value is in the interval in %d of 400",
           held);                   /* 380 +- 3 times sqrt(400 0.95 0.05) */
    TAP_OK(exact >= 368, "no error is claimed where there is none in %d of 400", exact);
}

/* The first level has an error of 1, which a scatter of 0.1 does not hide. */
static void error_and_scatter(void)
{
    const struct dem_refinement_series l =
        make(&(struct made){.c = 0.5, .p = 1.0, .own = 0.1, .runs = 8, .levels = 5}, 5);

    TAP_OK(fabs(l.level[0].error - 1.0) < l.level[0].uncertainty + 0.1,
           "an error larger than the scatter is reported: %g", l.level[0].error);
    TAP_OK(l.level[0].error > l.level[0].uncertainty, "it is larger than its uncertainty");
}

static void given(void)
{
    struct dem_refinement_series l =
        make(&(struct made){.c = 0.1, .p = 2.0, .runs = 2, .levels = 3}, 0);

    l.closed = 1;
    l.reference = truth;
    dem_refinement_evaluate(&l);
    TAP_OK(l.kind == DEM_REFINEMENT_CLOSED && l.uncertainty == 0.0,
           "a closed form has no uncertainty");
    TAP_NEAR(l.level[2].error, 0.1*0.25, 1e-12, "errors are differences from it");
}

/* Means that alternate: no order, and the uncertainty is the last difference. */
static void diverging(void)
{
    struct dem_refinement_series l;

    memset(&l, 0, sizeof l);
    l.levels = 3;
    for (int r = 0; r < 3; r++)
    {
        l.level[r] = (struct dem_refinement_level){
            .size = 4.0/(1 << r),
            .runs = 2,
            .value = {r%2, r%2}};
    }
    dem_refinement_evaluate(&l);
    TAP_NEAR(l.reference, 0.0, 0.0, "alternating means: the value is that of the finest level");
    TAP_OK(l.uncertainty >= 1.0, "alternating means: the uncertainty is the last difference");
    TAP_OK(isnan(l.order), "alternating means: no order");
}

int main(void)
{
    smooth();
    scattered();
    chaotic();
    error_and_scatter();
    given();
    diverging();
    TAP_DONE;
}
