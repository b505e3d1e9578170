/*
 * refinement_series.c -- mean, reference value, errors and observed order of a refinement series.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/refinement_series.h"
#include "core/block_means.h"
#include <math.h>

void dem_refinement_moments(const double *value, int n, double *mean, double *scatter)
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

const char *dem_refinement_kind_name(enum dem_refinement_kind kind)
{
    static const char *const names[] = {"closed form", "extrapolated", "statistics"};

    return names[kind];
}

/* Half the 95 % confidence interval of the mean of a level. */
static double interval(const struct dem_refinement_level *r)
{
    return r->runs > 1 ? dem_block_means_student_t95(r->runs - 1)*r->scatter/sqrt(r->runs) : 0.0;
}

/* ---- the reference --------------------------------------------------------------------------------------------- */

/* 1: the scatter is chaotic, not an error of the time step. Scatter by the phases of contacts
   relative to the step decreases at least linearly with the step; here a decrease slower than its
   square root counts as chaotic. */
static int is_chaotic(const struct dem_refinement_series *l)
{
    const struct dem_refinement_level *const coarse = &l->level[0];
    const struct dem_refinement_level *const fine = &l->level[l->levels - 1];
    double low = INFINITY, high = -INFINITY;

    for (int k = 0; k < l->levels; k++)
    {
        low = fmin(low, l->level[k].mean);
        high = fmax(high, l->level[k].mean);
    }
    return l->levels > 1 && fine->scatter > coarse->scatter*sqrt(fine->size/coarse->size) &&
           4.0*fine->scatter > high - low;
}

/* Richardson extrapolation from three levels, the finest of them `at`; returns 0 if they do not
   converge. *q: extrapolated value; *weight: factor of the difference of the two finer means in it.
   */
static int extrapolate(const struct dem_refinement_series *l, int at, double *q, double *weight)
{
    const struct dem_refinement_level *const r = l->level + at;
    const double fine = r[-1].mean - r[0].mean, coarse = r[-2].mean - r[-1].mean,
                 ratio = r[-1].size/r[0].size;
    const double p = coarse/fine > 0.0 ? log(coarse/fine)/log(ratio) : NAN;

    if (!isgreater(p, 0.5) || !isless(p, 4.0))
    {
        return 0;
    }
    *weight = 1.0/(pow(ratio, p) - 1.0);
    *q = r[0].mean - fine**weight;
    return 1;
}

static void set_reference(struct dem_refinement_series *l)
{
    const int last = l->levels - 1;
    const struct dem_refinement_level *const r = l->level + last;
    double q, weight, next, unused;

    l->kind = is_chaotic(l) ? DEM_REFINEMENT_STATISTICS : DEM_REFINEMENT_EXTRAPOLATED;
    l->reference = r->mean;
    l->uncertainty = interval(r);
    if (l->kind == DEM_REFINEMENT_STATISTICS || last == 0)
    {
        return;
    }
    const double noise = hypot(interval(r), interval(r - 1)), fine = fabs(r[-1].mean - r[0].mean);

    if (last < 2 || fine <= noise || !extrapolate(l, last, &q, &weight))
    {
        l->uncertainty = fmax(fine, last < 2 ? 0.0 : fabs(r[-2].mean - r[-1].mean)) + interval(r);
        return;
    }
    l->reference = q;
    next = last > 2 && extrapolate(l, last - 1, &next, &unused) ? next : r->mean;
    l->uncertainty = fabs(q - next) + weight*noise + interval(r);
}

/* ---- errors ---------------------------------------------------------------------------------------------------- */

static void set_error(const struct dem_refinement_series *l, struct dem_refinement_level *r)
{
    double squares = 0.0;

    r->uncertainty = l->uncertainty;
    if (l->kind == DEM_REFINEMENT_STATISTICS)
    {
        r->error = fabs(r->mean - l->reference);
        r->uncertainty =
            r == &l->level[l->levels - 1] ? l->uncertainty : hypot(interval(r), l->uncertainty);
        return;
    }
    for (int k = 0; k < r->runs; k++)
    {
        squares += (r->value[k] - l->reference)*(r->value[k] - l->reference);
    }
    r->error = sqrt(squares/r->runs);
}

static void fit_order(struct dem_refinement_series *l)
{
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, rest = 0.0;

    for (int k = 0; k < l->levels; k++)
    {
        const struct dem_refinement_level *const r = &l->level[k];
        const double counts = r->error > 2.0*r->uncertainty && r->error > 0.0 ? 1.0 : 0.0,
                     a = log(r->size), b = counts > 0.0 ? log(r->error) : 0.0;

        n += counts, x += counts*a, y += counts*b, xx += counts*a*a, xy += counts*a*b;
    }
    l->order = l->order_uncertainty = NAN;
    if (n < 3.0)
    {
        return;
    }
    const double spread = xx - x*x/n, slope = (xy - x*y/n)/spread;

    for (int k = 0; k < l->levels; k++)
    {
        const struct dem_refinement_level *const r = &l->level[k];
        const double off = r->error > 2.0*r->uncertainty && r->error > 0.0
                               ? log(r->error) - y/n - slope*(log(r->size) - x/n)
                               : 0.0;

        rest += off*off;
    }
    l->order = slope;
    l->order_uncertainty = sqrt(rest/(n - 2.0)/spread);
}

void dem_refinement_evaluate(struct dem_refinement_series *l)
{
    for (int k = 0; k < l->levels; k++)
    {
        dem_refinement_moments(l->level[k].value, l->level[k].runs, &l->level[k].mean,
                               &l->level[k].scatter);
    }
    if (l->closed)
    {
        l->kind = DEM_REFINEMENT_CLOSED;
        l->uncertainty = 0.0;
    }
    else
    {
        set_reference(l);
    }
    for (int k = 0; k < l->levels; k++)
    {
        set_error(l, &l->level[k]);
    }
    fit_order(l);
}
