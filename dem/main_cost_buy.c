/*
 * main_cost_buy.c -- what a user should do, in one sentence: the cheapest step whose worst quantity is surely within the target.
 *
 * What chaos hides is no reason for a finer step, and is told as what it is.
 *
 * Surely: its error and what that may be off by together. Where no rung is, the step that would be follows from the observed order of
 * the quantity that is worst at the finest rung, err ~ h^p, and its price from time ~ 1/h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main_cost.h"
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
static void say(struct sentence *s, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    const int n = vsnprintf(s->text + s->n, s->size - s->n, format, arguments);

    va_end(arguments);
    s->n = n > 0 && s->n + (size_t)n < s->size ? s->n + (size_t)n : s->size - 1;
}

/* The most that any quantity of a rung may be off by; infinite when it has none. *of: which one. */
static double bound(const struct dem_cost *c, const struct dem_cost_ladder *l, const struct dem_cost_rung *r, int *of)
{
    double most = r->runs > 0 && r->worst >= 0 ? 0.0 : INFINITY;

    *of = r->worst;
    for (int q = 0; q < c->quantities && r->runs > 0; q++)
    {
        const double may = l->told[q] && isfinite(r->error[q]) ? r->error[q] + r->unsure[q] : 0.0;

        *of = may > most ? q : *of;
        most = fmax(most, may);
    }
    return most;
}

static int cheapest(const struct dem_cost *c, const struct dem_cost_ladder *l)
{
    int best = -1, of;

    for (int k = 0; k < l->rungs; k++)
    {
        if (bound(c, l, &l->rung[k], &of) <= c->target && (best < 0 || l->rung[k].seconds < l->rung[best].seconds))
        {
            best = k;
        }
    }
    return best;
}

static double times(const struct dem_cost_ladder *l, const struct dem_cost_rung *r)
{
    return r->seconds/l->rung[l->base].seconds;
}

static void say_base(struct sentence *s, const struct dem_cost *c, const struct dem_cost_ladder *l)
{
    const struct dem_cost_rung *const r = &l->rung[l->base];
    int of;

    if (r->runs > 0 && r->worst >= 0)
    {
        say(s, "; the %s as it is has %.2g %%", c->noun, 100.0*bound(c, l, r, &of));
    }
}

static void say_price(struct sentence *s, const struct dem_cost_ladder *l, int quantity)
{
    const double p = quantity >= 0 ? l->judged[quantity].order : NAN;

    if (isgreater(p, 0.2))
    {
        say(s, ", half the error costs %.3g times the time (order %.2g)", pow(2.0, 1.0/p), p);
    }
}

static void say_chosen(struct sentence *s, const struct dem_cost *c, const struct dem_cost_ladder *l, int k)
{
    const struct dem_cost_rung *const r = &l->rung[k];
    int of;
    const double off = bound(c, l, r, &of);

    if (k == l->base)
    {
        say(s, "the %s as it is, step %.4g s: %s, the worst, is within %.2g %%, target %.3g %%", c->noun, r->step, c->quantity[of].name, 100.0*off,
            100.0*c->target);
    }
    else
    {
        say(s, "%s %.4g s (%s of the %s's%s): %s, the worst, is within %.2g %%, target %.3g %%, for %.3g times the processor time",
            l->entry, r->step, r->name, c->noun, r->step > c->limit*(1.0 + 1e-9) ? ", above the limit: with time/force yes" : "", c->quantity[of].name, 100.0*off,
            100.0*c->target, times(l, r));
        say_base(s, c, l);
    }
    say_price(s, l, of);
}

/* 1: what is not surely within the target is hidden by chaos, and only so. */
static int is_hidden(const struct dem_cost *c, const struct dem_cost_ladder *l, const struct dem_cost_rung *r)
{
    for (int q = 0; q < c->quantities; q++)
    {
        const int told = l->told[q] && isfinite(r->error[q]), chaos = l->judged[q].kind == DEM_LADDER_STATISTICS;

        if (told && r->error[q] + r->unsure[q] > c->target && !(chaos && r->error[q] <= r->unsure[q]))
        {
            return 0;
        }
    }
    return r->runs > 0 && r->worst >= 0;
}

static int cheapest_hidden(const struct dem_cost *c, const struct dem_cost_ladder *l)
{
    int best = -1;

    for (int k = 0; k < l->rungs; k++)
    {
        if (is_hidden(c, l, &l->rung[k]) && (best < 0 || l->rung[k].seconds < l->rung[best].seconds))
        {
            best = k;
        }
    }
    return best;
}

static void say_hidden(struct sentence *s, const struct dem_cost *c, const struct dem_cost_ladder *l, int k)
{
    const struct dem_cost_rung *const r = &l->rung[k];
    int of;
    const double off = bound(c, l, r, &of);

    say(s, "%s %.4g s (%s of the %s's%s), for %.3g times the processor time, can't be told from the finest rung: within %.2g %% (%s, "
        "the worst), which chaos hides in %d runs of this window; to tell %.3g %% ask for a longer -window or more -runs", l->entry, r->step,
        r->name, c->noun,
        r->step > c->limit*(1.0 + 1e-9) ? ", above the limit: with time/force yes" : "", times(l, r), 100.0*off, c->quantity[of].name, c->runs,
        100.0*c->target);
}

static void say_none(struct sentence *s, const struct dem_cost *c, const struct dem_cost_ladder *l)
{
    int last = l->rungs - 1, of;

    while (last > 0 && l->rung[last].runs == 0)
    {
        last--;
    }
    const struct dem_cost_rung *const r = &l->rung[last];
    const double off = bound(c, l, r, &of), p = of >= 0 ? l->judged[of].order : NAN;

    say(s, "no rung is within %.3g %%: %s has %.2g %% at the finest, step %.4g s", 100.0*c->target, of >= 0 ? c->quantity[of].name : "nothing",
        100.0*off, r->step);
    if (isgreater(p, 0.2))
    {
        const double shorter = pow(off/c->target, 1.0/p);

        say(s, "; by its order of %.2g a step of %.3g s would be, for %.3g times the processor time of the %s as it is", p, r->step/shorter,
            times(l, r)*shorter, c->noun);
    }
    say_base(s, c, l);
}

/* Mixed precision, where it adds next to nothing and saves more than clocks are off by. */
static void say_precision(struct sentence *s, const struct dem_cost *c)
{
    for (int n = 0; n < c->ladders; n++)
    {
        const struct dem_cost_ladder *const l = &c->ladder[n];
        int of;

        if (l->base == 1 && strcmp(l->rung[0].name, "mixed") == 0 && bound(c, l, &l->rung[0], &of) <= 0.1*c->target && times(l, &l->rung[0]) < 0.95)
        {
            say(s, "; time/precision mixed adds %.1g %% and takes %.2g of the time", 100.0*bound(c, l, &l->rung[0], &of), times(l, &l->rung[0]));
        }
    }
}

/* What the step can't mend. */
static void say_unmended(struct sentence *s, const struct dem_cost *c)
{
    for (int n = 0; n < c->ladders; n++)
    {
        const struct dem_cost_ladder *const l = &c->ladder[n];
        const struct dem_cost_rung *const r = l->base >= 0 ? &l->rung[l->base] : NULL;
        int of = -1;

        for (int q = 0; q < c->quantities && r && !l->exact && !l->paired && r->runs > 0; q++)
        {
            const int shows = l->told[q] && r->error[q] > r->unsure[q] && r->error[q] > c->target;

            of = shows && (of < 0 || r->error[q] > r->error[of]) ? q : of;
        }
        if (of >= 0 && strcmp(l->knob, "stiffness") == 0)
        {
            say(s, "; no step mends softness: %s is %.2g %% off hard spheres", c->quantity[of].name, 100.0*r->error[of]);
        }
        else if (of >= 0)
        {
            say(s, "; no step mends %s: %s is %.2g %% off", l->knob, c->quantity[of].name, 100.0*r->error[of]);
        }
    }
}

/* Which effects do nothing here that shows, and what all of those take. */
static void say_effects(struct sentence *s, const struct dem_cost *c, const struct dem_cost_ladder *l)
{
    double saved = 0.0;
    int idle = 0, of;

    for (int k = 0; k < l->base; k++)
    {
        const struct dem_cost_rung *const r = &l->rung[k];

        if (r->runs > 0 && r->worst >= 0 && bound(c, l, r, &of) <= c->target)
        {
            say(s, "%s%s", idle++ > 0 ? ", " : "without ", r->name);
            saved += 1.0 - times(l, r);
        }
    }
    if (idle == 0)
    {
        say(s, "each effect changes something by more than %.3g %%, or chaos hides that it does not", 100.0*c->target);
        return;
    }
    say(s, " nothing changes by more than %.3g %% in this window, each alone; together they take %.2g %% of the processor time", 100.0*c->target,
        100.0*fmax(0.0, saved));
}

void dem_cost_buy(const struct dem_cost *c, char *text, size_t size)
{
    struct sentence s = {.text = text, .size = size};
    const struct dem_cost_ladder *const l = &c->ladder[0];

    text[0] = '\0';
    if (c->ladders > 0 && strcmp(l->knob, "effects") == 0)
    {
        say_effects(&s, c, l);
        return;
    }
    if (c->ladders == 0 || !l->exact)
    {
        say(&s, "ask for the ladder of %s to have one", c->request.scene ? "steps (-ladders step)" : "intervals (-ladders interval)");
        return;
    }
    const int k = cheapest(c, l), hidden = cheapest_hidden(c, l);

    if (k >= 0)
    {
        say_chosen(&s, c, l, k);
    }
    else if (hidden >= 0)
    {
        say_hidden(&s, c, l, hidden);
    }
    else
    {
        say_none(&s, c, l);
    }
    say_unmended(&s, c);
    say_precision(&s, c);
}
