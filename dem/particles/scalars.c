/*
 * scalars.c -- columns of the particle scalars, windows of an exchange, and the check of values.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/scalars.h"
#include "core/error.h"
#include "core/random.h"
#include <math.h>
#include <string.h>

enum
{
    USE_SCALAR = 301    /* first of the sequences of random numbers, one a scalar */
};

static void add_to(struct dem_column_list *list, int column)
{
    list->column[list->n++] = column;
}

/* A column that batches have, and ghosts if an effect of contacts reads it. */
static int add_batch_column(struct dem_particles *p, const struct dem_interaction_table *r,
                            const struct dem_scalar *s, int column)
{
    DEM_REQUIRE(p->batch.n < DEM_BATCH_COLUMNS, DEM_ERROR_INPUT,
                "particle scalar %s: batches have more than %d columns of scalars", s->name,
                (int)DEM_BATCH_COLUMNS);
    if (dem_interaction_table_needs(r) & s->batch.contact_needs)
    {
        add_to(&p->ghost_window, column);
    }
    p->batch.at[p->batch.n].column = column;
    p->batch.at[p->batch.n++].to = &s->batch;
    return DEM_OK;
}

int dem_scalars_add_columns(struct dem_particles *p, const struct dem_interaction_table *r)
{
    int columns = r->scalars;

    for (int k = 0; k < r->scalars; k++)
    {
        columns += r->exchanged[k] ? DEM_SCALAR_COLUMNS : 0;
    }
    DEM_REQUIRE(columns <= DEM_FURTHER_COLUMNS, DEM_ERROR_INPUT,
                "the particle scalars of the effects need %d columns, the limit is %d; choose "
                "fewer effects", columns, (int)DEM_FURTHER_COLUMNS);
    for (int k = 0; k < r->scalars; k++)
    {
        const int column = dem_particles_add_column(p, r->scalar[k]->name);

        if (r->scalar[k]->flags & DEM_SCALAR_PARTNERS)
        {
            add_to(r->scalar[k]->flags & DEM_SCALAR_RATE ? &p->ghost_step : &p->ghost_window,
                   column);
        }
        if (k >= r->listed)
        {
            DEM_TRY(add_batch_column(p, r, r->scalar[k], column));
        }
    }
    for (int k = 0; k < r->scalars; k++)
    {
        for (int c = 0; r->exchanged[k] && c < DEM_SCALAR_COLUMNS; c++)
        {
            (void)dem_particles_add_column(p, r->scalar[k]->exchange[c]);
        }
    }
    return DEM_OK;
}

double *dem_scalar_values_of(const struct dem_particles *p, const struct dem_interaction_table *r,
                             const char *name)
{
    const int scalar = dem_interaction_table_find_scalar(r, name);

    return scalar < 0 ? NULL : dem_scalar_values(p, scalar);
}

double *dem_scalar_exchange_values(const struct dem_particles *p,
                                   const struct dem_interaction_table *r, int scalar,
                                   enum dem_scalar_column which)
{
    int column = DEM_COLUMNS + r->scalars + (int)which;

    for (int k = 0; k < scalar; k++)
    {
        column += r->exchanged[k] ? DEM_SCALAR_COLUMNS : 0;
    }
    return r->exchanged[scalar] ? p->column[column].data : NULL;
}

/* ---- windows --------------------------------------------------------------------------------- */

void dem_scalars_begin_window(struct dem_particles *p, const struct dem_interaction_table *r)
{
    const size_t size = p->n*sizeof(double);

    for (int k = 0; k < r->scalars; k++)
    {
        double *const decay = dem_scalar_exchange_values(p, r, k, DEM_SCALAR_DECAY);

        if (decay && p->n > 0)
        {
            memset(dem_scalar_exchange_values(p, r, k, DEM_SCALAR_RECEIVED), 0, size);
            memset(dem_scalar_exchange_values(p, r, k, DEM_SCALAR_TIME), 0, size);
            memset(dem_scalar_exchange_values(p, r, k, DEM_SCALAR_TARGET_TIME), 0, size);
            memcpy(dem_scalar_exchange_values(p, r, k, DEM_SCALAR_START),
                   dem_scalar_values(p, k), size);
        }
        for (size_t i = 0; decay && i < p->n; i++)
        {
            decay[i] = 1.0;
        }
    }
}

void dem_scalars_begin_particle(struct dem_particles *p, const struct dem_interaction_table *r,
                                size_t i)
{
    for (int k = 0; k < r->scalars; k++)
    {
        if (r->exchanged[k])
        {
            dem_scalar_exchange_values(p, r, k, DEM_SCALAR_DECAY)[i] = 1.0;
            dem_scalar_exchange_values(p, r, k, DEM_SCALAR_START)[i] = dem_scalar_values(p, k)[i];
        }
    }
}

/* R = clamp(|J|/|s* - s(start)|, C (1 - decay), sum of B h), s* the mean target: as the response of
   momentum to the fluid's velocity. */
static void respond(struct dem_particles *p, const struct dem_interaction_table *r, int k)
{
    const double *const time = dem_scalar_exchange_values(p, r, k, DEM_SCALAR_TIME),
                 *const decay = dem_scalar_exchange_values(p, r, k, DEM_SCALAR_DECAY),
                 *const received = dem_scalar_exchange_values(p, r, k, DEM_SCALAR_RECEIVED),
                 *const to_target = dem_scalar_exchange_values(p, r, k, DEM_SCALAR_TARGET_TIME),
                 *const start = dem_scalar_exchange_values(p, r, k, DEM_SCALAR_START);
    double *const response = dem_scalar_exchange_values(p, r, k, DEM_SCALAR_RESPONSE);

    for (size_t i = 0; response && i < p->n; i++)
    {
        const struct dem_particle *const q = &p->record[i];
        const double free = dem_interaction_table_capacity(r, k, q->material, q->mass)*
                            (1.0 - decay[i]);
        const double held = fabs(to_target[i] - time[i]*start[i]), J = fabs(received[i]);
        const double measured = J >= held ? time[i] : time[i]*J/held;

        response[i] = measured > free ? measured : free;
    }
}

void dem_scalars_end_window(struct dem_particles *p, const struct dem_interaction_table *r)
{
    for (int k = 0; k < r->scalars; k++)
    {
        respond(p, r, k);
    }
}

/* ---- values ---------------------------------------------------------------------------------- */

int dem_scalars_check(const struct dem_particles *p, const struct dem_interaction_table *r,
                      const char *when)
{
    for (int k = 0; k < r->scalars; k++)
    {
        const struct dem_scalar *const s = r->scalar[k];
        const double *const value = dem_scalar_values(p, k);

        for (size_t i = 0; i < p->n; i++)
        {
            const struct dem_particle *const q = &p->record[i];

            DEM_REQUIRE(isfinite(value[i]) && value[i] >= s->min && value[i] <= s->max,
                        DEM_ERROR_NUMBER,
                        "%s of particle %lld at (%g %g %g) m is %g %s%s; it must be a number from "
                        "%g to %g; give it in insert, or use a smaller time/step",
                        s->name, (long long)q->id, q->x[0], q->x[1], q->x[2], value[i], s->unit,
                        when, s->min, s->max);
        }
    }
    return DEM_OK;
}

double dem_scalar_draw(const struct dem_scalar_entry *e, int scalar, uint64_t seed, uint64_t number)
{
    return e->min == e->max
               ? e->min
               : e->min + (e->max - e->min)*
                              dem_random_unit(seed, number, 0, USE_SCALAR + (uint64_t)scalar);
}
