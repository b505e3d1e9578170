/*
 * cost_errors.c -- from the runs of all series: errors of all quantities over their scales,
 * processor times, Pareto front.
 *
 * Scales. In general the reference value. Kinetic energy: at least 1e-6 of the energy of a fall by
 * one diameter (untilQuiet's criterion for rest), so that noise at rest is not an error. Rotation:
 * at least the target error times the scale of the kinetic energy, so that a trace of spin is not
 * one. Height: the mean diameter. Contacts: at least one for each particle. Restitution: 1.
 *
 * Paired series (mixed precision with double, laws of friction, effects) are compared with the base
 * run by run, with the same steps in both: the error is the root mean square of the differences. If
 * the trajectories have diverged (it exceeds a quarter of the scatter of runs), the means are
 * compared.
 *
 * The processor time of a level is that of its fastest run, per step, as other work on the machine
 * can only add to it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/cost.h"
#include "core/block_means.h"
#include <math.h>
#include <string.h>

static const double rest_fraction = 1e-6;

void dem_cost_scene_quantities(struct dem_cost *c)
{
    static const struct dem_cost_quantity_name own[DEM_COST_SCENE_QUANTITIES] = {
        {"kinetic", "J"}, {"rotation", "J"}, {"height", "m"}, {"overlap", "1"},
        {"force", "N"}, {"contacts", "1"}, {"restitution", "1"},
    };

    memcpy(c->quantity, own, sizeof own);
    c->quantities = DEM_COST_SCENE_QUANTITIES;
    c->noun = "scene";
}

static void time_level(const struct dem_cost *c, struct dem_cost_level *r)
{
    double min = INFINITY, max = 0.0;

    for (int k = 0; k < r->runs; k++)
    {
        const double per_step = r->run[k].seconds/(double)r->run[k].steps;

        min = fmin(min, per_step);
        max = fmax(max, per_step);
    }
    r->seconds = r->runs > 0 ? min*c->window/r->step : NAN;
    r->spread = r->runs > 0 ? max/min : NAN;
}

/* The levels that have this quantity, in the form of advisor/refinement_series.h; index[k]: index
   in the series of level k of these. */
static int collect(const struct dem_cost_series *l, int quantity, struct dem_refinement_series *j,
                   int index[DEM_REFINEMENT_LEVELS])
{
    j->levels = 0;
    for (int k = 0; k < l->levels; k++)
    {
        const struct dem_cost_level *const r = &l->level[k];
        struct dem_refinement_level *const to = &j->level[j->levels];
        int complete = r->runs > 0;

        *to = (struct dem_refinement_level){.size = r->size, .runs = r->runs};
        for (int n = 0; n < r->runs; n++)
        {
            to->value[n] = r->run[n].value[quantity];
            complete = complete && isfinite(to->value[n]);
        }
        index[j->levels] = k;
        j->levels += complete;
    }
    return j->levels;
}

/* 1: the quantity is zero in all runs, for example rotation without friction. */
static int is_zero(const struct dem_refinement_series *j)
{
    for (int k = 0; k < j->levels; k++)
    {
        for (int n = 0; n < j->level[k].runs; n++)
        {
            if (j->level[k].value[n] != 0.0)
            {
                return 0;
            }
        }
    }
    return 1;
}

static double scale_of(const struct dem_cost *c, int quantity, double reference)
{
    switch (c->request.scene ? quantity : DEM_COST_SCENE_QUANTITIES)
    {
    case DEM_COST_KINETIC:
        return fmax(fabs(reference), rest_fraction*c->fall);
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

static void analyze_quantity(struct dem_cost *c, struct dem_cost_series *l, int quantity)
{
    struct dem_refinement_series *const j = &l->analysis[quantity];
    int index[DEM_REFINEMENT_LEVELS];

    /* the result at other stiffnesses differs from the scene's closed form; in a table the closed
       form is the exact value for all */
    j->closed = (l->exact || !c->request.scene) && c->has_closed_form[quantity];
    j->reference = c->closed_form[quantity];
    if (collect(l, quantity, j, index) == 0 || is_zero(j))
    {
        l->reported[quantity] = 0;
        return;
    }
    dem_refinement_evaluate(j);
    c->scale[quantity] =
        c->scale[quantity] > 0.0 ? c->scale[quantity] : scale_of(c, quantity, j->reference);
    for (int k = 0; k < j->levels; k++)
    {
        struct dem_cost_level *const r = &l->level[index[k]];

        r->error[quantity] = c->scale[quantity] > 0.0 ? j->level[k].error/c->scale[quantity] : NAN;
        r->uncertainty[quantity] =
            c->scale[quantity] > 0.0 ? j->level[k].uncertainty/c->scale[quantity] : NAN;
    }
    l->reported[quantity] = c->scale[quantity] > 0.0;
}

/* Compare a level, level 0 of j, with the base, level 1 of j, run by run. */
static void compare(const struct dem_cost *c, struct dem_refinement_series *j,
                    struct dem_cost_level *r, int quantity)
{
    struct dem_refinement_level *const own = &j->level[0];
    double difference[DEM_REFINEMENT_RUNS], mean, scatter, squares = 0.0;

    for (int k = 0; k < own->runs; k++)
    {
        difference[k] = own->value[k] - j->level[1].value[k];
        squares += difference[k]*difference[k];
    }
    dem_refinement_moments(j->level[1].value, own->runs, &j->reference, &scatter);
    dem_refinement_moments(difference, own->runs, &mean, &own->scatter);
    own->mean = j->reference + mean;
    own->error = sqrt(squares/own->runs);
    own->uncertainty = 0.0;
    if (4.0*own->error > scatter && scatter > 0.0)    /* the trajectories have diverged */
    {
        own->error = fabs(mean);
        own->uncertainty = dem_block_means_student_t95(own->runs - 1)*own->scatter/sqrt(own->runs);
    }
    r->error[quantity] = own->error/c->scale[quantity];
    r->uncertainty[quantity] = own->uncertainty/c->scale[quantity];
}

/* Compare all levels with the base, the last one. */
static void compare_all(struct dem_cost *c, struct dem_cost_series *l, int quantity)
{
    struct dem_refinement_series *const j = &l->analysis[quantity];
    int index[DEM_REFINEMENT_LEVELS];
    const int n = collect(l, quantity, j, index);

    l->reported[quantity] = n > 1 && index[n - 1] == l->base && !is_zero(j);
    if (!l->reported[quantity])
    {
        return;
    }
    for (int k = 0; k < n; k++)
    {
        dem_refinement_moments(j->level[k].value, j->level[k].runs, &j->level[k].mean,
                               &j->level[k].scatter);
    }
    j->kind = DEM_REFINEMENT_STATISTICS;    /* so that an interval is reported */
    j->order = j->order_uncertainty = NAN;
    j->reference = j->level[n - 1].mean;
    j->uncertainty = 0.0;
    c->scale[quantity] =
        c->scale[quantity] > 0.0 ? c->scale[quantity] : scale_of(c, quantity, j->reference);
    l->reported[quantity] = c->scale[quantity] > 0.0;
    for (int k = 0; k < n && l->reported[quantity]; k++)
    {
        struct dem_refinement_series pair = {.levels = 2, .level = {j->level[k], j->level[n - 1]}};

        compare(c, &pair, &l->level[index[k]], quantity);
    }
}

static void find_worst(const struct dem_cost *c, const struct dem_cost_series *l,
                       struct dem_cost_level *r)
{
    r->worst = -1;
    for (int q = 0; q < c->quantities; q++)
    {
        if (l->reported[q] && isfinite(r->error[q])
            && (r->worst < 0 || r->error[q] > r->error[r->worst]))
        {
            r->worst = q;
        }
    }
}

static void find_pareto(struct dem_cost_series *l)
{
    for (int k = 0; k < l->levels; k++)
    {
        l->level[k].pareto = l->level[k].worst >= 0 && !l->paired;
        for (int n = 0; n < l->levels && l->level[k].pareto; n++)
        {
            const struct dem_cost_level *const a = &l->level[k], *const b = &l->level[n];

            l->level[k].pareto = !(n != k && b->worst >= 0 && b->seconds <= a->seconds
                                   && b->error[b->worst] <= a->error[a->worst]);
        }
    }
}

void dem_cost_find_errors(struct dem_cost *c)
{
    for (int n = 0; n < c->n_series; n++)
    {
        struct dem_cost_series *const l = &c->series[n];

        for (int k = 0; k < l->levels; k++)
        {
            time_level(c, &l->level[k]);
            for (int q = 0; q < c->quantities; q++)
            {
                l->level[k].error[q] = l->level[k].uncertainty[q] = NAN;
            }
        }
        for (int q = 0; q < c->quantities; q++)
        {
            if (c->wanted[q] && l->reported[q])
            {
                (l->paired ? compare_all : analyze_quantity)(c, l, q);
            }
        }
        for (int k = 0; k < l->levels; k++)
        {
            find_worst(c, l, &l->level[k]);
        }
        find_pareto(l);
    }
}
