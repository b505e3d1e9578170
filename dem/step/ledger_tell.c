/*
 * ledger_tell.c -- the terms of the ledger by name, and their total.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/vec.h"
#include "step/ledger.h"
#include "step/measure.h"
#include "step/parts.h"
#include <stdio.h>
#include <string.h>

/* One more term, by name. */
static void add(struct dem_ledger *l, const char *kind, const char *of, double value)
{
    struct dem_energy_item *const item = &l->item[l->items++];

    snprintf(item->name, sizeof item->name, "%s%s", kind, of);
    item->value = value;
}

/* J: translation, rotation; the same on all ranks. */
static void kinetic(const struct dem_parts *p, double value[2])
{
    struct dem_sum sum[2];

    dem_sum_clear(&sum[0]);
    dem_sum_clear(&sum[1]);
    for (size_t i = 0; i < p->particles.n; i++)
    {
        const struct dem_particle *const r = &p->particles.record[i];
        const double inertia = 0.4*r->mass*r->radius*r->radius;

        dem_sum_add(&sum[0], 0.5*r->mass*dem_vec_dot(r->v, r->v));
        dem_sum_add(&sum[1], 0.5*inertia*dem_vec_dot(r->w, r->w));
    }
    dem_measure_sums(p, sum, 2, value);
}

static double value_of(const struct dem_parts *p, const struct dem_sum *kept)
{
    struct dem_sum sum = *kept;
    double value;

    dem_measure_sums(p, &sum, 1, &value);
    return value;
}

/* A law of contact without memory is a function of the overlap, or of it and the motion: it has no spring to tell of, or
   no heat. */
static int tells_elastic(const struct dem_effect *e)
{
    return e->energy ? e->stage == DEM_STAGE_NORMAL || e->stage >= DEM_STAGE_BOND || (e->stage > DEM_STAGE_DAMP && e->memory)
                     : e->stage >= DEM_STAGE_BOND;
}

static int tells_lost(const struct dem_effect *e)
{
    return e->stage != DEM_STAGE_NORMAL || e->memory;
}

/* The terms of contact effects: what is stored, then what is lost. Returns their sum. */
static double tell_contacts(struct dem_parts *p)
{
    struct dem_ledger *const l = &p->ledger;
    double lost[DEM_CHAIN], total = 0.0;

    for (int k = 0; k < p->recipe.chosen && p->recipe.effect[k]->stage < DEM_STAGE_BODY; k++)
    {
        const struct dem_effect *const e = p->recipe.effect[k];
        const double stored = value_of(p, &dem_ledger_of(l, e)[DEM_LEDGER_STORED]);

        lost[k] = value_of(p, &dem_ledger_of(l, e)[DEM_LEDGER_LOST]);
        total += stored + lost[k];
        if (tells_elastic(e))
        {
            add(l, "elastic_", e->name, stored);
        }
    }
    for (int k = 0; k < p->recipe.chosen && p->recipe.effect[k]->stage < DEM_STAGE_BODY; k++)
    {
        const struct dem_effect *const e = p->recipe.effect[k];

        if (!e->energy && e->stage < DEM_STAGE_BOND)
        {
            add(l, "measured_", e->name, lost[k]);
        }
        else if (tells_lost(e))
        {
            add(l, "lost_", e->name, lost[k]);
        }
    }
    return total;
}

/* The heat of drag and the work of fluid and other bodies. Returns heat less work. */
static double tell_bodies(struct dem_parts *p)
{
    struct dem_ledger *const l = &p->ledger;
    double total = 0.0;

    for (int k = 0; k < p->recipe.chosen; k++)
    {
        const struct dem_effect *const e = p->recipe.effect[k];

        if (e->stage >= DEM_STAGE_BODY && strcmp(e->name, "gravity") != 0)
        {
            const double lost = value_of(p, &dem_ledger_of(l, e)[DEM_LEDGER_LOST]);
            const double work = value_of(p, &dem_ledger_of(l, e)[DEM_LEDGER_WORK]);

            if (e->drag)
            {
                add(l, "lost_", e->name, lost);
            }
            add(l, "work_", e->name, work);
            total += lost - work;
        }
    }
    return total;
}

static int has_stage(const struct dem_recipe *r, enum dem_stage stage)
{
    int has = 0;

    for (int k = 0; k < r->chosen; k++)
    {
        has |= r->effect[k]->stage == stage;
    }
    return has;
}

static double tell_all(struct dem_parts *p)
{
    struct dem_ledger *const l = &p->ledger;
    const double fell = value_of(p, &l->sum[DEM_LEDGER_FALL]), broken = value_of(p, &l->sum[DEM_LEDGER_BROKEN]);
    const double walls = value_of(p, &l->sum[DEM_LEDGER_WALLS]), left = value_of(p, &l->sum[DEM_LEDGER_LEFT]);
    const double came = value_of(p, &l->sum[DEM_LEDGER_CAME]);
    double moving[2], total;

    l->items = 0;
    kinetic(p, moving);
    add(l, "kinetic_translation", "", moving[0]);
    add(l, "kinetic_rotation", "", moving[1]);
    if (dem_recipe_acts(&p->recipe, "gravity"))
    {
        add(l, "gravity", "", -fell);
    }
    total = moving[0] + moving[1] - fell + tell_contacts(p);
    if (has_stage(&p->recipe, DEM_STAGE_BOND))
    {
        add(l, "broken", "", broken);
    }
    if (!p->walls.plain)
    {
        add(l, "work_walls", "", walls);
    }
    total += broken - walls + tell_bodies(p);
    if (p->domain.remove || p->flows.n > 0)
    {
        add(l, "left", "", left);
    }
    if (p->flows.n > 0)
    {
        add(l, "came", "", came);
    }
    return total + left - came;
}

void dem_ledger_begin(struct dem_parts *p)
{
    p->ledger.start = tell_all(p);                        /* with those outside the domain, who leave again later */
    dem_sum_clear(&p->ledger.sum[DEM_LEDGER_LEFT]);
    p->ledger.since = p->time;
    p->ledger.begun = 1;
}

void dem_ledger_tell(struct dem_parts *p)
{
    struct dem_ledger *const l = &p->ledger;
    const double total = tell_all(p);

    add(l, "total", "", total);
    add(l, "residual", "", total - l->start);
}
