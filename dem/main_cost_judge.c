/*
 * main_cost_judge.c -- from the runs of all ladders: errors of all quantities as shares of their scales, time, the front.
 *
 * Scales: the reference itself; of kinetic energy at least a millionth of what falling by a diameter would give (what untilQuiet calls
 * at rest), of its rotation at least the target's share of the whole, so that noise at rest and a trace of spin are no errors; of heights
 * the mean diameter; of contacts at least one a particle; of restitution 1. Mixed precision is compared run by run with double, the same steps in both; where the two have gone other ways (they
 * differ by a quarter of what runs scatter by), mean with mean.
 *
 * Processor time of a rung is that of its quickest run, by the step: other work on the machine only adds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main_cost.h"
#include "base/blocks.h"
#include <math.h>
#include <string.h>

static const double at_rest = 1e-6;

void dem_cost_name_own(struct dem_cost *c)
{
    static const struct dem_cost_named own[DEM_COST_OWN] =
    {
        {"kinetic", "J"}, {"rotation", "J"}, {"height", "m"}, {"overlap", "1"}, {"force", "N"}, {"contacts", "1"}, {"restitution", "1"},
    };

    memcpy(c->quantity, own, sizeof own);
    c->quantities = DEM_COST_OWN;
    c->noun = "scene";
}

static void time_rung(const struct dem_cost *c, struct dem_cost_rung *r)
{
    double least = INFINITY, most = 0.0;

    for (int k = 0; k < r->runs; k++)
    {
        const double each = r->run[k].seconds/(double)r->run[k].steps;

        least = fmin(least, each);
        most = fmax(most, each);
    }
    r->seconds = r->runs > 0 ? least*c->window/r->step : NAN;
    r->spread = r->runs > 0 ? most/least : NAN;
}

/* The rungs that have this quantity, as plan/ladder.h wants them; place[k]: where rung k of those stands among all. */
static int collect(const struct dem_cost_ladder *l, int quantity, struct dem_ladder *j, int place[DEM_LADDER_RUNGS])
{
    j->rungs = 0;
    for (int k = 0; k < l->rungs; k++)
    {
        const struct dem_cost_rung *const r = &l->rung[k];
        struct dem_ladder_rung *const to = &j->rung[j->rungs];
        int good = r->runs > 0;

        *to = (struct dem_ladder_rung){.size = r->size, .runs = r->runs};
        for (int n = 0; n < r->runs; n++)
        {
            to->value[n] = r->run[n].value[quantity];
            good = good && isfinite(to->value[n]);
        }
        place[j->rungs] = k;
        j->rungs += good;
    }
    return j->rungs;
}

/* Nothing of it ever shows: no rotation without friction, say. */
static int is_nought(const struct dem_ladder *j)
{
    for (int k = 0; k < j->rungs; k++)
    {
        for (int n = 0; n < j->rung[k].runs; n++)
        {
            if (j->rung[k].value[n] != 0.0)
            {
                return 0;
            }
        }
    }
    return 1;
}

static double own_scale(const struct dem_cost *c, int quantity, double reference)
{
    switch (c->request.scene ? quantity : DEM_COST_OWN)
    {
    case DEM_COST_KINETIC:
        return fmax(fabs(reference), at_rest*c->fall);
    case DEM_COST_ROTATION:
        return fmax(fabs(reference), c->target*c->scale[DEM_COST_KINETIC]);
    case DEM_COST_HEIGHT:
        return c->diameter;
    case DEM_COST_RESTITUTION:
        return 1.0;
    case DEM_COST_CONTACTS:
        return fmax(fabs(reference), 1.0);
    default:
        return fabs(reference);
    }
}

static void judge_quantity(struct dem_cost *c, struct dem_cost_ladder *l, int quantity)
{
    struct dem_ladder *const j = &l->judged[quantity];
    int place[DEM_LADDER_RUNGS];

    /* softness moves what comes of a scene away from its closed form; of a table the form is what must come out */
    j->closed = (l->exact || !c->request.scene) && c->closed[quantity];
    j->reference = c->form[quantity];
    if (collect(l, quantity, j, place) == 0 || is_nought(j))
    {
        l->told[quantity] = 0;
        return;
    }
    dem_ladder_judge(j);
    c->scale[quantity] = c->scale[quantity] > 0.0 ? c->scale[quantity] : own_scale(c, quantity, j->reference);
    for (int k = 0; k < j->rungs; k++)
    {
        struct dem_cost_rung *const r = &l->rung[place[k]];

        r->error[quantity] = c->scale[quantity] > 0.0 ? j->rung[k].error/c->scale[quantity] : NAN;
        r->unsure[quantity] = c->scale[quantity] > 0.0 ? j->rung[k].unsure/c->scale[quantity] : NAN;
    }
    l->told[quantity] = c->scale[quantity] > 0.0;
}

/* One rung with the base, run by run: rungs 0 and 1 of j. */
static void compare(const struct dem_cost *c, struct dem_ladder *j, struct dem_cost_rung *r, int quantity)
{
    struct dem_ladder_rung *const own = &j->rung[0];
    double apart[DEM_LADDER_RUNS], mean, scatter, squares = 0.0;

    for (int k = 0; k < own->runs; k++)
    {
        apart[k] = own->value[k] - j->rung[1].value[k];
        squares += apart[k]*apart[k];
    }
    dem_ladder_moments(j->rung[1].value, own->runs, &j->reference, &scatter);
    dem_ladder_moments(apart, own->runs, &mean, &own->scatter);
    own->mean = j->reference + mean;
    own->error = sqrt(squares/own->runs);
    own->unsure = 0.0;
    if (4.0*own->error > scatter && scatter > 0.0)        /* they have gone other ways */
    {
        own->error = fabs(mean);
        own->unsure = dem_blocks_student(own->runs - 1)*own->scatter/sqrt(own->runs);
    }
    r->error[quantity] = own->error/c->scale[quantity];
    r->unsure[quantity] = own->unsure/c->scale[quantity];
}

/* The base is the last rung. */
static void compare_all(struct dem_cost *c, struct dem_cost_ladder *l, int quantity)
{
    struct dem_ladder *const j = &l->judged[quantity];
    int place[DEM_LADDER_RUNGS];
    const int n = collect(l, quantity, j, place);

    l->told[quantity] = n > 1 && place[n - 1] == l->base && !is_nought(j);
    if (!l->told[quantity])
    {
        return;
    }
    for (int k = 0; k < n; k++)
    {
        dem_ladder_moments(j->rung[k].value, j->rung[k].runs, &j->rung[k].mean, &j->rung[k].scatter);
    }
    j->kind = DEM_LADDER_STATISTICS;                      /* where an interval is told */
    j->order = j->order_unsure = NAN;
    j->reference = j->rung[n - 1].mean;
    j->unsure = 0.0;
    c->scale[quantity] = c->scale[quantity] > 0.0 ? c->scale[quantity] : own_scale(c, quantity, j->reference);
    l->told[quantity] = c->scale[quantity] > 0.0;
    for (int k = 0; k < n && l->told[quantity]; k++)
    {
        struct dem_ladder both = {.rungs = 2, .rung = {j->rung[k], j->rung[n - 1]}};

        compare(c, &both, &l->rung[place[k]], quantity);
    }
}

static void find_worst(const struct dem_cost *c, const struct dem_cost_ladder *l, struct dem_cost_rung *r)
{
    r->worst = -1;
    for (int q = 0; q < c->quantities; q++)
    {
        if (l->told[q] && isfinite(r->error[q]) && (r->worst < 0 || r->error[q] > r->error[r->worst]))
        {
            r->worst = q;
        }
    }
}

static void find_front(struct dem_cost_ladder *l)
{
    for (int k = 0; k < l->rungs; k++)
    {
        l->rung[k].front = l->rung[k].worst >= 0 && !l->paired;
        for (int n = 0; n < l->rungs && l->rung[k].front; n++)
        {
            const struct dem_cost_rung *const a = &l->rung[k], *const b = &l->rung[n];

            l->rung[k].front = !(n != k && b->worst >= 0 && b->seconds <= a->seconds && b->error[b->worst] <= a->error[a->worst]);
        }
    }
}

void dem_cost_judge(struct dem_cost *c)
{
    for (int n = 0; n < c->ladders; n++)
    {
        struct dem_cost_ladder *const l = &c->ladder[n];

        for (int k = 0; k < l->rungs; k++)
        {
            time_rung(c, &l->rung[k]);
            for (int q = 0; q < c->quantities; q++)
            {
                l->rung[k].error[q] = l->rung[k].unsure[q] = NAN;
            }
        }
        for (int q = 0; q < c->quantities; q++)
        {
            if (c->wanted[q] && l->told[q])
            {
                (l->paired ? compare_all : judge_quantity)(c, l, q);
            }
        }
        for (int k = 0; k < l->rungs; k++)
        {
            find_worst(c, l, &l->rung[k]);
        }
        find_front(l);
    }
}
