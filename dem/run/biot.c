/*
 * biot.c -- Biot number of the particles: how well heat spreads within a particle, compared with how
 * well it leaves it. One temperature per particle holds for small ones.
 *
 *   contacts    Bi = H/(2 pi k R)         H: conductance of all effects of a contact [W/K]
 *   fluid       Bi = h V/(A k) = B/(12 pi k R)         B: coefficient of heat transfer [W/K]
 *
 *   k    conductivity of the particle     [W/(m K)]
 *   R    radius of the smallest particle: equal ones meet; of the Sauter mean in the fluid    [m]
 *
 * 2 pi k R is the conductance of a half sphere, V and A volume and surface. The effects
 * themselves give H, at an overlap of 1 % of the diameter, and B, at the slip that is asked for.
 *
 * Source: Incropera and DeWitt, Fundamentals of Heat and Mass Transfer, section 5.1; contacts:
 * Vargas and McCarthy, AIChE J. 47 (2001) 1052.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "dem_numbers.h"
#include "laws/effects.h"
#include <string.h>

static const double pi = 3.14159265358979324, overlap_ratio = 0.01;

enum
{
    LANES = 8    /* rows of a batch, all the same */
};

static int exchanges_heat(const struct dem_effect *e)
{
    return e->scalars && e->scalars[0]->flags & DEM_SCALAR_HEAT;
}

static void fill(double *column, double value)
{
    for (int c = 0; c < LANES; c++)
    {
        column[c] = value;
    }
}

/* ---- contacts --------------------------------------------------------------------------------- */

struct columns    /* of the scalars of a batch */
{
    _Alignas(64) double i[DEM_BATCH_ROWS], j[DEM_BATCH_ROWS];
    _Alignas(64) double rate_i[DEM_BATCH_ROWS], rate_j[DEM_BATCH_ROWS], rest[DEM_BATCH_ROWS];
};

/* W/K: what a particle that is 1 K warmer than its partner loses */
static double conductance(const struct dem_effect_list *list, double R)
{
    struct dem_contact_batch b;
    struct columns t;
    struct dem_scalar_rows rows[DEM_EFFECT_SCALARS];
    const double depth = overlap_ratio*2.0*R, reach = list->pair.with_wall ? R : 2.0*R;

    memset(&b, 0, sizeof b);
    memset(&t, 0, sizeof t);
    b.n = LANES;
    b.scalars = rows;
    fill(b.overlap, depth);
    fill(b.touching, 1.0);
    fill(b.is_primary, 1.0);
    fill(b.reduced_radius, list->pair.with_wall ? R : 0.5*R);
    fill(b.min_radius, R);
    fill(b.distance, reach - depth);
    fill(b.gap, -depth);
    fill(t.i, 301.0);
    fill(t.j, 300.0);
    for (int k = 0; k < DEM_EFFECT_SCALARS; k++)
    {
        rows[k] =
            (struct dem_scalar_rows){.i = t.i, .j = t.j, .rate_i = t.rate_i, .rate_j = t.rate_j};
    }
    for (int k = 0; k < list->entries; k++)
    {
        if (exchanges_heat(list->entry[k].effect))
        {
            list->entry[k].effect->apply(list->entry[k].settings, &b, NULL);
        }
    }
    return -t.rate_i[0];
}

static void take(struct dem_biot *most, double number, const struct dem_material *of,
                 const struct dem_material *other)
{
    const double k = of->thermal.conductivity;

    if (k > 0.0 && number/k > most->number)
    {
        *most = (struct dem_biot){.number = number/k,
                                  .material = of->name,
                                  .other = other ? other->name : NULL,
                                  .conductivity = k};
    }
}

static void of_contacts(const struct dem_interaction_table *r, struct dem_biot *most)
{
    for (int c = 0; c < r->classes; c++)
    {
        const struct dem_pair_class *const pair = &r->list[c].pair;
        const double R = pair->with_wall ? pair->min_radius : 2.0*pair->min_radius,
                     ratio = conductance(&r->list[c], R)/(2.0*pi*R);

        take(most, ratio, pair->a, pair->b);
        if (!pair->with_wall)
        {
            take(most, ratio, pair->b, pair->a);
        }
    }
}

/* ---- the fluid -------------------------------------------------------------------------------- */

static double value_of(const struct dem_uniform_fluid *f, const struct dem_interaction_table *r,
                       const struct dem_scalar *s)
{
    double value = 300.0;

    for (int k = 0; k < f->scalars; k++)
    {
        value = r->scalar[f->scalar[k]] == s ? f->value[k] : value;
    }
    return value;
}

/* W/K */
static double transfer(const struct dem_effect_entry *entry, const struct dem *d, double diameter,
                       double slip)
{
    const struct dem_uniform_fluid *const f = &d->scene.fluid;
    const double R = 0.5*diameter;
    struct dem_body_batch b;
    struct columns t[DEM_EFFECT_SCALARS];
    struct dem_scalar_bodies rows[DEM_EFFECT_SCALARS];

    memset(&b, 0, sizeof b);
    memset(t, 0, sizeof t);
    b.n = LANES;
    b.scalars = rows;
    fill(b.radius, R);
    fill(b.volume, 4.0/3.0*pi*R*R*R);
    fill(b.ux, slip);
    fill(b.void_fraction, f->void_fraction);
    fill(b.density, f->density);
    fill(b.viscosity, f->viscosity);
    for (int k = 0; entry->effect->scalars[k]; k++)
    {
        fill(t[k].i, value_of(f, &d->state.interaction_table, entry->effect->scalars[k]));
        rows[k] = (struct dem_scalar_bodies){.value = t[k].i,
                                             .rate = t[k].rate_i,
                                             .coefficient = t[k].rate_j,
                                             .to_target = t[k].rest};
    }
    entry->effect->apply_to_bodies(entry->settings, &b);
    return t[0].rate_j[0];
}

/* For the uniform fluid of a scene; a coupled program's fluid is not known before the run. */
static void of_fluid(const struct dem *d, double diameter, double slip, struct dem_biot *most)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;

    for (int k = 0; k < r->bodies.entries && d->scene.fluid.given && diameter > 0.0; k++)
    {
        if (r->bodies.entry[k].effect->transfers && exchanges_heat(r->bodies.entry[k].effect))
        {
            const double ratio = transfer(&r->bodies.entry[k], d, diameter, slip)/(6.0*pi*diameter);

            for (int m = 0; m < r->materials; m++)
            {
                take(most, r->max_radius[m] > 0.0 ? ratio : 0.0, &r->material[m], NULL);
            }
        }
    }
}

void dem_biot_number(const struct dem *d, double diameter, double slip, struct dem_biot *most)
{
    *most = (struct dem_biot){.number = 0.0};
    of_contacts(&d->state.interaction_table, most);
    of_fluid(d, diameter, slip, most);
}
