/*
 * cost_best_buy.c -- the best buy in one sentence: the cheapest step whose worst quantity is within
 * the target error.
 *
 * "Within" includes the uncertainty: error + uncertainty <= target. If no level satisfies that,
 *
 *   - levels at which only statistical (chaotic) quantities exceed the target, with errors not
 *     above their uncertainty, are reported as not distinguishable from the finest level: a finer
 *     step would not help, a longer window or more runs would;
 *   - else a step is extrapolated with the observed order p of the quantity that is worst at the
 *     finest level, error ~ h^p, and its processor time with time ~ 1/h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/cost.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

struct sentence
{
    char *text;
    size_t size, n;
};

__attribute__((format(printf, 2, 3)))
static void append(struct sentence *s, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    const int n = vsnprintf(s->text + s->n, s->size - s->n, format, arguments);

    va_end(arguments);
    s->n = n > 0 && s->n + (size_t)n < s->size ? s->n + (size_t)n : s->size - 1;
}

/* Upper bound of the error of a level: largest error + uncertainty of its quantities; infinite if
   it has none. *of: which quantity. */
static double error_bound(const struct dem_cost *c, const struct dem_cost_series *l,
                          const struct dem_cost_level *r, int *of)
{
    double max = r->runs > 0 && r->worst >= 0 ? 0.0 : INFINITY;

    *of = r->worst;
    for (int q = 0; q < c->quantities && r->runs > 0; q++)
    {
        const double error =
            l->reported[q] && isfinite(r->error[q]) ? r->error[q] + r->uncertainty[q] : 0.0;

        *of = error > max ? q : *of;
        max = fmax(max, error);
    }
    return max;
}

static int cheapest(const struct dem_cost *c, const struct dem_cost_series *l)
{
    int best = -1, of;

    for (int k = 0; k < l->levels; k++)
    {
        if (error_bound(c, l, &l->level[k], &of) <= c->target
            && (best < 0 || l->level[k].seconds < l->level[best].seconds))
        {
            best = k;
        }
    }
    return best;
}

static double times(const struct dem_cost_series *l, const struct dem_cost_level *r)
{
    return r->seconds/l->level[l->base].seconds;
}

static void append_base(struct sentence *s, const struct dem_cost *c,
                        const struct dem_cost_series *l)
{
    const struct dem_cost_level *const r = &l->level[l->base];
    int of;

    if (r->runs > 0 && r->worst >= 0)
    {
        append(s, "; the %s as it is has %.2g %%", c->noun, 100.0*error_bound(c, l, r, &of));
    }
}

static void append_price(struct sentence *s, const struct dem_cost_series *l, int quantity)
{
    const double p = quantity >= 0 ? l->analysis[quantity].order : NAN;

    if (isgreater(p, 0.2))
    {
        append(s, ", half the error costs %.3g times the time (order %.2g)", pow(2.0, 1.0/p), p);
    }
}

static void append_chosen(struct sentence *s, const struct dem_cost *c,
                          const struct dem_cost_series *l, int k)
{
    const struct dem_cost_level *const r = &l->level[k];
    int of;
    const double bound = error_bound(c, l, r, &of);

    if (k == l->base)
    {
        append(s, "the %s as it is, step %.4g s: %s, the worst, is within %.2g %%, target %.3g %%",
               c->noun, r->step, c->quantity[of].name, 100.0*bound, 100.0*c->target);
    }
    else
    {
        append(s,
               "%s %.4g s (%s of the %s's%s): %s, the worst, is within %.2g %%, target %.3g %%, "
               "for %.3g times the processor time",
               l->entry, r->step, r->name, c->noun,
               r->step > c->limit*(1.0 + 1e-9) ? ", above the limit: with time/force yes" : "",
               c->quantity[of].name, 100.0*bound, 100.0*c->target, times(l, r));
        append_base(s, c, l);
    }
    append_price(s, l, of);
}

/* 1: all quantities that exceed the target are statistical, with errors not above their
   uncertainty. */
static int is_indistinct(const struct dem_cost *c, const struct dem_cost_series *l,
                         const struct dem_cost_level *r)
{
    for (int q = 0; q < c->quantities; q++)
    {
        const int reported = l->reported[q] && isfinite(r->error[q]);
        const int statistical = l->analysis[q].kind == DEM_REFINEMENT_STATISTICS;

        if (reported && r->error[q] + r->uncertainty[q] > c->target
            && !(statistical && r->error[q] <= r->uncertainty[q]))
        {
            return 0;
        }
    }
    return r->runs > 0 && r->worst >= 0;
}

static int cheapest_indistinct(const struct dem_cost *c, const struct dem_cost_series *l)
{
    int best = -1;

    for (int k = 0; k < l->levels; k++)
    {
        if (is_indistinct(c, l, &l->level[k])
            && (best < 0 || l->level[k].seconds < l->level[best].seconds))
        {
            best = k;
        }
    }
    return best;
}

static void append_indistinct(struct sentence *s, const struct dem_cost *c,
                              const struct dem_cost_series *l, int k)
{
    const struct dem_cost_level *const r = &l->level[k];
    int of;
    const double bound = error_bound(c, l, r, &of);

    append(s,
           "%s %.4g s (%s of the %s's%s), for %.3g times the processor time, cannot be "
           "distinguished from the finest level: within %.2g %% (%s, the worst), the scatter of %d "
           "chaotic runs of this window; to resolve %.3g %% use a longer -window or more -runs",
           l->entry, r->step, r->name, c->noun,
           r->step > c->limit*(1.0 + 1e-9) ? ", above the limit: with time/force yes" : "",
           times(l, r), 100.0*bound, c->quantity[of].name, c->runs, 100.0*c->target);
}

static void append_none(struct sentence *s, const struct dem_cost *c,
                        const struct dem_cost_series *l)
{
    int last = l->levels - 1, of;

    while (last > 0 && l->level[last].runs == 0)
    {
        last--;
    }
    const struct dem_cost_level *const r = &l->level[last];
    const double bound = error_bound(c, l, r, &of), p = of >= 0 ? l->analysis[of].order : NAN;

    append(s, "no level is within %.3g %%: %s has %.2g %% at the finest, step %.4g s",
           100.0*c->target, of >= 0 ? c->quantity[of].name : "nothing", 100.0*bound, r->step);
    if (isgreater(p, 0.2))
    {
        const double ratio = pow(bound/c->target, 1.0/p);

        append(s,
               "; by its order of %.2g a step of %.3g s would be, for %.3g times the processor "
               "time of the %s as it is",
               p, r->step/ratio, times(l, r)*ratio, c->noun);
    }
    append_base(s, c, l);
}

/* Mixed precision, if it adds less than a tenth of the target and saves more than the noise of
   timing. */
static void append_precision(struct sentence *s, const struct dem_cost *c)
{
    for (int n = 0; n < c->n_series; n++)
    {
        const struct dem_cost_series *const l = &c->series[n];
        int of;

        if (l->base == 1 && strcmp(l->level[0].name, "mixed") == 0
            && error_bound(c, l, &l->level[0], &of) <= 0.1*c->target
            && times(l, &l->level[0]) < 0.95)
        {
            append(s, "; time/precision mixed adds %.1g %% and takes %.2g of the time",
                   100.0*error_bound(c, l, &l->level[0], &of), times(l, &l->level[0]));
        }
    }
}

/* Errors that do not depend on the step. */
static void append_other_errors(struct sentence *s, const struct dem_cost *c)
{
    for (int n = 0; n < c->n_series; n++)
    {
        const struct dem_cost_series *const l = &c->series[n];
        const struct dem_cost_level *const r = l->base >= 0 ? &l->level[l->base] : NULL;
        int of = -1;

        for (int q = 0; q < c->quantities && r && !l->exact && !l->paired && r->runs > 0; q++)
        {
            const int significant =
                l->reported[q] && r->error[q] > r->uncertainty[q] && r->error[q] > c->target;

            of = significant && (of < 0 || r->error[q] > r->error[of]) ? q : of;
        }
        if (of >= 0 && strcmp(l->parameter, "stiffness") == 0)
        {
            append(s, "; no step removes the error of softness: %s is %.2g %% off hard spheres",
                   c->quantity[of].name, 100.0*r->error[of]);
        }
        else if (of >= 0)
        {
            append(s, "; no step removes the error of %s: %s is %.2g %% off", l->parameter,
                   c->quantity[of].name, 100.0*r->error[of]);
        }
    }
}

/* The effects without which no quantity changes by more than the target, and their processor time.
   */
static void append_effects(struct sentence *s, const struct dem_cost *c,
                           const struct dem_cost_series *l)
{
    double saved = 0.0;
    int idle = 0, of;

    for (int k = 0; k < l->base; k++)
    {
        const struct dem_cost_level *const r = &l->level[k];

        if (r->runs > 0 && r->worst >= 0 && error_bound(c, l, r, &of) <= c->target)
        {
            append(s, "%s%s", idle++ > 0 ? ", " : "without ", r->name);
            saved += 1.0 - times(l, r);
        }
    }
    if (idle == 0)
    {
        append(s,
               "each effect changes something by more than %.3g %%, or the scatter of chaotic runs "
               "is larger than that",
               100.0*c->target);
        return;
    }
    append(s,
           " nothing changes by more than %.3g %% in this window, each alone; together they take "
           "%.2g %% of the processor time",
           100.0*c->target, 100.0*fmax(0.0, saved));
}

void dem_cost_best_buy(const struct dem_cost *c, char *text, size_t size)
{
    struct sentence s = {.text = text, .size = size};
    const struct dem_cost_series *const l = &c->series[0];

    text[0] = '\0';
    if (c->n_series > 0 && strcmp(l->parameter, "effects") == 0)
    {
        append_effects(&s, c, l);
        return;
    }
    if (c->n_series == 0 || !l->exact)
    {
        append(&s, "needs the series of %s",
               c->request.scene ? "steps (-series step)" : "intervals (-series interval)");
        return;
    }
    const int k = cheapest(c, l), indistinct = cheapest_indistinct(c, l);

    if (k >= 0)
    {
        append_chosen(&s, c, l, k);
    }
    else if (indistinct >= 0)
    {
        append_indistinct(&s, c, l, indistinct);
    }
    else
    {
        append_none(&s, c, l);
    }
    append_other_errors(&s, c);
    append_precision(&s, c);
}
