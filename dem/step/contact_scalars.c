/*
 * contact_scalars.c -- gather scalars of the partners of a contact batch, select an effect's own,
 * store rates.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/contact_scalars.h"
#include "particles/scalars.h"
#include <string.h>

static const double pi = 3.14159265358979323846;

/* The condition of a wall at this time; NULL: insulated. */
static const struct dem_wall_scalar *condition(const struct dem_state *state,
                                               const struct dem_pair *q, int scalar)
{
    const int wall = state->walls.facet[dem_pairs_facet(&state->pairs, q->j)].wall;
    const struct dem_wall_scalar *const w =
        state->walls.wall[wall].scalars ? &state->walls.wall[wall].scalars[scalar] : NULL;

    /* times are sums of steps: a step that ends at the start, to rounding, is before it */
    return w && state->time > w->start*(1.0 + 1e-12) && state->time <= w->end*(1.0 + 1e-12) ? w
                                                                                            : NULL;
}

/* What a wall gives to a particle of radius R that touches it: flux or film on the area pi R^2. A
   given value is left to the effects. */
static double rate_of_wall(const struct dem_wall_scalar *w, double radius, double value)
{
    return pi*radius*radius*(w->flux + w->film*(w->value - value));
}

static void gather_radii(struct dem_contact_scalars *s, const struct dem_state *state,
                         const struct dem_contact_batch *b, uint32_t row, int rows)
{
    for (int c = 0; c < b->n; c++)
    {
        const struct dem_pair *const q =
            dem_contacts_pair(&state->contacts, row + (uint32_t)(c < rows ? c : rows - 1));

        s->radius[0][c] = state->particles.record[q->i].radius;
        s->radius[1][c] = state->particles.record[q->wall ? q->i : q->j].radius;
    }
}

void dem_contact_scalars_gather(struct dem_contact_scalars *s, const struct dem_state *state,
                                const struct dem_contact_batch *b, uint32_t row, int rows)
{
    for (int k = 0; k < state->interaction_table.listed; k++)
    {
        const double *const all = dem_scalar_values(&state->particles, k);
        double *const of_i = s->value[0][k], *const of_j = s->value[1][k];

        memset(s->rate[0][k], 0, sizeof s->rate[0][k]);
        memset(s->rate[1][k], 0, sizeof s->rate[1][k]);
        for (int c = 0; c < b->n; c++)
        {
            const struct dem_pair *const q =
                dem_contacts_pair(&state->contacts, row + (uint32_t)(c < rows ? c : rows - 1));
            const struct dem_wall_scalar *const w = q->wall ? condition(state, q, k) : NULL;

            of_i[c] = all[q->i];
            of_j[c] = !q->wall ? all[q->j] : w && w->given ? w->value : of_i[c];
            s->rate[0][k][c] =
                w ? b->touching[c]*rate_of_wall(w, b->min_radius[c], of_i[c]) : 0.0;
        }
    }
    if (state->interaction_table.needs & DEM_NEEDS_RADII)
    {
        gather_radii(s, state, b, row, rows);
    }
}

void dem_contact_scalars_select(struct dem_contact_workspace *t,
                                const struct dem_effect_entry *entry)
{
    struct dem_contact_scalars *const s = t->scalars;

    for (int m = 0; m < entry->scalars; m++)
    {
        const int k = entry->scalar[m];

        s->rows[m] = (struct dem_scalar_rows){.i = s->value[0][k],
                                              .j = s->value[1][k],
                                              .rate_i = s->rate[0][k],
                                              .rate_j = s->rate[1][k],
                                              .radius_i = s->radius[0],
                                              .radius_j = s->radius[1]};
    }
    t->batch.scalars = s->rows;
}

void dem_contact_scalars_store(const struct dem_contact_scalars *s, struct dem_contacts *contacts,
                               uint32_t row, int rows)
{
    const int n = contacts->forces.rates;
    double *to = contacts->forces.rate + 2*(size_t)n*row;

    for (int c = 0; c < rows; c++)
    {
        for (int k = 0; k < n; k++)
        {
            *to++ = s->rate[0][k][c];
            *to++ = s->rate[1][k][c];
        }
    }
}
