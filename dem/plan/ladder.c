/*
 * ladder.c -- means, the reference, errors, the order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "plan/ladder.h"
#include "base/blocks.h"
#include <math.h>

void dem_ladder_moments(const double *value, int n, double *mean, double *scatter)
{
    double sum = 0.0, squares = 0.0;

    for (int k = 0; k < n; k++)
    {
        sum += value[k] - value[0];
    }
    *mean = value[0] + sum/n;
    for (int k = 0; k < n; k++)
    {
        squares += (value[k] - *mean)*(value[k] - *mean);
    }
    *scatter = n > 1 ? sqrt(squares/(n - 1)) : 0.0;
}

const char *dem_ladder_kind_name(enum dem_ladder_kind kind)
{
    static const char *const names[] = {"closed form", "extrapolated", "statistics"};

    return names[kind];
}

/* Half the 95 % interval of a rung's mean. */
static double interval(const struct dem_ladder_rung *r)
{
    return r->runs > 1 ? dem_blocks_student(r->runs - 1)*r->scatter/sqrt(r->runs) : 0.0;
}

/* ---- the reference --------------------------------------------------------------------------------------------- */

/* 1: the scatter is the scene's own. Phases of contacts against the step scatter less with a shorter step, by its first power or
   more; half a power is what chaos could not do by chance. */
static int is_chaotic(const struct dem_ladder *l)
{
    const struct dem_ladder_rung *const coarse = &l->rung[0], *const fine = &l->rung[l->rungs - 1];
    double low = INFINITY, high = -INFINITY;

    for (int k = 0; k < l->rungs; k++)
    {
        low = fmin(low, l->rung[k].mean);
        high = fmax(high, l->rung[k].mean);
    }
    return l->rungs > 1 && fine->scatter > coarse->scatter*sqrt(fine->size/coarse->size) && 4.0*fine->scatter > high - low;
}

/* What three rungs say, the finest of them rung `at`; 0 when they don't close in on a value. *stretch: how a difference of the two
   finer means weighs in q. */
static int extrapolate(const struct dem_ladder *l, int at, double *q, double *stretch)
{
    const struct dem_ladder_rung *const r = l->rung + at;
    const double fine = r[-1].mean - r[0].mean, coarse = r[-2].mean - r[-1].mean, ratio = r[-1].size/r[0].size;
    const double p = coarse/fine > 0.0 ? log(coarse/fine)/log(ratio) : NAN;

    if (!isgreater(p, 0.5) || !isless(p, 4.0))
    {
        return 0;
    }
    *stretch = 1.0/(pow(ratio, p) - 1.0);
    *q = r[0].mean - fine**stretch;
    return 1;
}

static void refer(struct dem_ladder *l)
{
    const int last = l->rungs - 1;
    const struct dem_ladder_rung *const r = l->rung + last;
    double q, stretch, next, ignored;

    l->kind = is_chaotic(l) ? DEM_LADDER_STATISTICS : DEM_LADDER_EXTRAPOLATED;
    l->reference = r->mean;
    l->unsure = interval(r);
    if (l->kind == DEM_LADDER_STATISTICS || last == 0)
    {
        return;
    }
    const double noise = hypot(interval(r), interval(r - 1)), fine = fabs(r[-1].mean - r[0].mean);

    if (last < 2 || fine <= noise || !extrapolate(l, last, &q, &stretch))
    {
        l->unsure = fmax(fine, last < 2 ? 0.0 : fabs(r[-2].mean - r[-1].mean)) + interval(r);
        return;
    }
    l->reference = q;
    next = last > 2 && extrapolate(l, last - 1, &next, &ignored) ? next : r->mean;
    l->unsure = fabs(q - next) + stretch*noise + interval(r);
}

/* ---- errors ---------------------------------------------------------------------------------------------------- */

static void weigh(const struct dem_ladder *l, struct dem_ladder_rung *r)
{
    double squares = 0.0;

    r->unsure = l->unsure;
    if (l->kind == DEM_LADDER_STATISTICS)
    {
        r->error = fabs(r->mean - l->reference);
        r->unsure = r == &l->rung[l->rungs - 1] ? l->unsure : hypot(interval(r), l->unsure);
        return;
    }
    for (int k = 0; k < r->runs; k++)
    {
        squares += (r->value[k] - l->reference)*(r->value[k] - l->reference);
    }
    r->error = sqrt(squares/r->runs);
}

static void fit_order(struct dem_ladder *l)
{
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, rest = 0.0;

    for (int k = 0; k < l->rungs; k++)
    {
        const struct dem_ladder_rung *const r = &l->rung[k];
        const double tells = r->error > 2.0*r->unsure && r->error > 0.0 ? 1.0 : 0.0, a = log(r->size), b = tells > 0.0 ? log(r->error) : 0.0;

        n += tells, x += tells*a, y += tells*b, xx += tells*a*a, xy += tells*a*b;
    }
    l->order = l->order_unsure = NAN;
    if (n < 3.0)
    {
        return;
    }
    const double spread = xx - x*x/n, slope = (xy - x*y/n)/spread;

    for (int k = 0; k < l->rungs; k++)
    {
        const struct dem_ladder_rung *const r = &l->rung[k];
        const double off = r->error > 2.0*r->unsure && r->error > 0.0 ? log(r->error) - y/n - slope*(log(r->size) - x/n) : 0.0;

        rest += off*off;
    }
    l->order = slope;
    l->order_unsure = sqrt(rest/(n - 2.0)/spread);
}

void dem_ladder_judge(struct dem_ladder *l)
{
    for (int k = 0; k < l->rungs; k++)
    {
        dem_ladder_moments(l->rung[k].value, l->rung[k].runs, &l->rung[k].mean, &l->rung[k].scatter);
    }
    if (l->closed)
    {
        l->kind = DEM_LADDER_CLOSED;
        l->unsure = 0.0;
    }
    else
    {
        refer(l);
    }
    for (int k = 0; k < l->rungs; k++)
    {
        weigh(l, &l->rung[k]);
    }
    fit_order(l);
}
