/*
 * Claims: a ladder of runs gives back the value, the order and the errors it was made from; where its scatter is the scene's own, the
 * 95 % interval holds the truth in 95 of 100 ladders; where means do not close in on a value, nothing is claimed that is not so.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "unit/tap.h"

#include "base/random.h"
#include "plan/ladder.h"

#include <math.h>
#include <string.h>

static const double truth = 3.0;

/* even in -1 to 1 */
static double chance(uint64_t ladder, uint64_t number)
{
    return 2.0*dem_random_unit(7, ladder, number, 0) - 1.0;
}

struct made                                               /* value = truth + c h^p + phase h x + own y, x and y by chance */
{
    double c, p, phase, own;
    int runs, rungs;
};

static struct dem_ladder make(const struct made *m, uint64_t number)
{
    struct dem_ladder l;
    uint64_t k = 0;

    memset(&l, 0, sizeof l);
    l.rungs = m->rungs;
    for (int r = 0; r < m->rungs; r++)
    {
        const double h = 2.0/(1 << r);

        l.rung[r] = (struct dem_ladder_rung){.size = h, .runs = m->runs};
        for (int n = 0; n < m->runs; n++)
        {
            l.rung[r].value[n] = truth + m->c*pow(h, m->p) + m->phase*h*chance(number, k) + m->own*chance(number, k + 1);
            k += 2;
        }
    }
    dem_ladder_judge(&l);
    return l;
}

static void smooth(void)
{
    for (double p = 1.0; p < 3.0; p += 0.5)
    {
        const struct dem_ladder l = make(&(struct made){.c = 0.2, .p = p, .runs = 3, .rungs = 5}, 0);

        TAP_OK(l.kind == DEM_LADDER_EXTRAPOLATED, "a smooth ladder is extrapolated");
        TAP_NEAR(l.reference, truth, 1e-12, "to the truth");                                  /* round-off */
        TAP_NEAR(l.order, p, 1e-9, "with its order");
        TAP_NEAR(l.rung[0].error, 0.2*pow(2.0, p), 1e-12, "and its errors");
        TAP_OK(l.unsure < 1e-12 && l.order_unsure < 1e-9, "and is sure of it");
    }
}

/* 0.2 h and a scatter of 0.05 h, whose means differ by chance: what is told as unsure must hold the truth nearly always */
static void scattered(void)
{
    int held = 0, extrapolated = 0;

    for (uint64_t k = 0; k < 400; k++)
    {
        const struct dem_ladder l = make(&(struct made){.c = 0.2, .p = 1.0, .phase = 0.05, .runs = 5, .rungs = 5}, k);

        held += fabs(l.reference - truth) <= l.unsure;
        extrapolated += l.kind == DEM_LADDER_EXTRAPOLATED;
    }
    TAP_OK(extrapolated >= 390, "scatter that falls with the step is the step's: %d of 400", extrapolated);
    TAP_OK(held >= 380, "the truth is within what is unsure in %d of 400", held);             /* 95 % */
}

static void chaotic(void)
{
    int held = 0, statistics = 0, exact = 0;

    for (uint64_t k = 0; k < 400; k++)
    {
        const struct dem_ladder l = make(&(struct made){.own = 0.1, .runs = 5, .rungs = 5}, 1000 + k);

        statistics += l.kind == DEM_LADDER_STATISTICS;
        held += fabs(l.reference - truth) <= l.unsure;
        exact += l.rung[1].error <= l.rung[1].unsure;
    }
    TAP_OK(statistics >= 380, "scatter that stays is the scene's: %d of 400", statistics);
    TAP_OK(held >= 368, "the truth is in the interval in %d of 400", held);                   /* 380 +- 3 times sqrt(400 0.95 0.05) */
    TAP_OK(exact >= 368, "and no error is claimed where there is none in %d of 400", exact);
}

/* The first rung is off by 1, of which chaos of 0.1 hides nothing. */
static void beside_chaos(void)
{
    const struct dem_ladder l = make(&(struct made){.c = 0.5, .p = 1.0, .own = 0.1, .runs = 8, .rungs = 5}, 5);

    TAP_OK(fabs(l.rung[0].error - 1.0) < l.rung[0].unsure + 0.1, "an error beside chaos is seen: %g", l.rung[0].error);
    TAP_OK(l.rung[0].error > l.rung[0].unsure, "and told from it");
}

static void given(void)
{
    struct dem_ladder l = make(&(struct made){.c = 0.1, .p = 2.0, .runs = 2, .rungs = 3}, 0);

    l.closed = 1;
    l.reference = truth;
    dem_ladder_judge(&l);
    TAP_OK(l.kind == DEM_LADDER_CLOSED && l.unsure == 0.0, "a closed form is sure");
    TAP_NEAR(l.rung[2].error, 0.1*0.25, 1e-12, "errors are from it");
}

/* Means that go to and fro: no order, and the last difference is what may be wrong. */
static void restless(void)
{
    struct dem_ladder l;

    memset(&l, 0, sizeof l);
    l.rungs = 3;
    for (int r = 0; r < 3; r++)
    {
        l.rung[r] = (struct dem_ladder_rung){.size = 4.0/(1 << r), .runs = 2, .value = {r%2, r%2}};
    }
    dem_ladder_judge(&l);
    TAP_NEAR(l.reference, 0.0, 0.0, "the finest");
    TAP_OK(l.unsure >= 1.0, "is unsure by all of the last difference");
    TAP_OK(isnan(l.order), "and there is no order");
}

int main(void)
{
    smooth();
    scattered();
    chaotic();
    beside_chaos();
    given();
    restless();
    TAP_DONE;
}
