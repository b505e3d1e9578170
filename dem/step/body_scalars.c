/*
 * body_scalars.c -- gather and integrate the scalars of a batch of particles.
 *
 * A particle adds the rates of its rows in the order of partner ids, as it adds forces, so the result
 * does not depend on the ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/body_scalars.h"
#include "core/math.h"
#include "particles/scalars.h"
#include <string.h>

double dem_body_scalars_contacts(const struct dem_contacts *c, int scalar, size_t particle)
{
    const struct dem_contact_rows *const rows = &c->rows;
    const size_t width = 2*(size_t)c->forces.rates;
    double sum = 0.0;

    for (uint32_t e = rows->start[particle]; e < rows->start[particle + 1]; e++)
    {
        const uint32_t entry = rows->entry[e],
                       row = dem_contact_forces_row(&c->forces, rows, particle, entry);

        sum += c->forces.rate[width*row + 2*(size_t)scalar + (entry & DEM_ENTRY_SIDE)];
    }
    return sum;
}

/* What the program adds: a source, a coefficient with its target, and what it carries over. */
static void add_exchange(struct dem_body_scalars *s, const struct dem_scalar_step *step,
                         const struct dem_particles *particles, int k, size_t first, int rows)
{
    const struct dem_interaction_table *const r = step->table;
    const double *const source = dem_scalar_exchange_values(particles, r, k, DEM_SCALAR_SOURCE),
                 *const b = dem_scalar_exchange_values(particles, r, k, DEM_SCALAR_COEFFICIENT),
                 *const target = dem_scalar_exchange_values(particles, r, k, DEM_SCALAR_TARGET),
                 *const over = dem_scalar_exchange_values(particles, r, k, DEM_SCALAR_CARRIED_OVER);
    const double per_window = step->window > 0.0 ? 1.0/step->window : 0.0;

    for (int c = 0; c < rows; c++)
    {
        const size_t i = first + (size_t)c;

        s->rate[k][c] += source[i] + per_window*over[i];
        s->coefficient[k][c] += b[i];
        s->to_target[k][c] += b[i]*target[i];
    }
}

void dem_body_scalars_gather(struct dem_body_scalars *s, const struct dem_scalar_step *step,
                             const struct dem_particles *particles, size_t first, int rows)
{
    for (int k = 0; k < step->table->listed; k++)
    {
        const double *const value = dem_scalar_values(particles, k) + first;

        for (int c = 0; c < DEM_BATCH_ROWS; c++)
        {
            s->value[k][c] = value[c < rows ? c : rows - 1];
        }
        memset(s->rate[k], 0, sizeof s->rate[k]);
        memset(s->coefficient[k], 0, sizeof s->coefficient[k]);
        memset(s->to_target[k], 0, sizeof s->to_target[k]);
        for (int c = 0; c < rows && step->h > 0.0 && step->contacts->forces.rates; c++)
        {
            s->rate[k][c] = dem_body_scalars_contacts(step->contacts, k, first + (size_t)c);
        }
        if (step->h > 0.0 && step->table->exchanged[k])
        {
            add_exchange(s, step, particles, k, first, rows);
        }
    }
}

void dem_body_scalars_select(struct dem_body_scalars *s, struct dem_body_batch *b,
                             const struct dem_effect_entry *entry)
{
    for (int m = 0; m < entry->scalars; m++)
    {
        const int k = entry->scalar[m];

        s->rows[m] = (struct dem_scalar_bodies){.value = s->value[k],
                                                .rate = s->rate[k],
                                                .coefficient = s->coefficient[k],
                                                .to_target = s->to_target[k]};
    }
    b->scalars = s->rows;
}

/* What the coefficients gave, for the partner of the exchange; z = B h/C. */
static void sum_exchange(const struct dem_body_scalars *s, const struct dem_scalar_step *step,
                         const struct dem_particles *particles, int k, size_t first, int c,
                         double z)
{
    const struct dem_interaction_table *const r = step->table;
    const size_t i = first + (size_t)c;
    const double phi = dem_phi(z), given = s->to_target[k][c] - s->coefficient[k][c]*s->value[k][c];

    dem_scalar_exchange_values(particles, r, k, DEM_SCALAR_RECEIVED)[i] +=
        step->h*(phi*given - (1.0 - phi)*s->rate[k][c]);
    dem_scalar_exchange_values(particles, r, k, DEM_SCALAR_TIME)[i] += step->h*s->coefficient[k][c];
    dem_scalar_exchange_values(particles, r, k, DEM_SCALAR_TARGET_TIME)[i] +=
        step->h*s->to_target[k][c];
    dem_scalar_exchange_values(particles, r, k, DEM_SCALAR_DECAY)[i] *= 1.0 - z*phi;
}

/* For the energy balance: what the step adds, less what contacts add. */
static void sum_heat(const struct dem_scalar_step *step, int k, size_t particle, double rate)
{
    const double contacts =
        step->contacts->forces.rates ? dem_body_scalars_contacts(step->contacts, k, particle) : 0.0;

    dem_sum_add(step->heat, step->h*rate);
    dem_sum_add(step->heat, -step->h*contacts);
}

int dem_body_scalars_integrate(const struct dem_body_scalars *s, const struct dem_scalar_step *step,
                               struct dem_particles *particles, size_t first, int rows)
{
    const struct dem_interaction_table *const r = step->table;
    int bad = 0;

    for (int k = 0; k < r->listed; k++)
    {
        double *const value = dem_scalar_values(particles, k) + first;

        for (int c = 0; c < rows && r->scalar[k]->flags & DEM_SCALAR_RATE; c++)
        {
            const struct dem_particle *const q = &particles->record[first + (size_t)c];

            if (q->body)    /* clump_heat.c */
            {
                continue;
            }
            const double per_capacity =
                step->h/dem_interaction_table_capacity(r, k, q->material, q->mass);
            const double B = s->coefficient[k][c], z = B*per_capacity;

            const double rate = s->rate[k][c] + s->to_target[k][c] - B*value[c];

            value[c] += dem_phi(z)*per_capacity*rate;
            if (step->heat && r->scalar[k]->flags & DEM_SCALAR_HEAT)
            {
                sum_heat(step, k, first + (size_t)c, dem_phi(z)*rate);
            }
            bad += !(value[c] >= r->scalar[k]->min && value[c] <= r->scalar[k]->max);
            if (r->exchanged[k])
            {
                sum_exchange(s, step, particles, k, first, c, z);
            }
        }
    }
    return bad;
}
