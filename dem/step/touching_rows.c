/*
 * touching_rows.c -- select the rows of a stretch that touch, and sweep them in batches.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/touching_rows.h"
#include "core/vec4.h"
#include "laws/effect.h"
#include "records/energy_balance.h"
#include "step/contact_effects.h"
#include "step/fill_batch.h"
#include "step/limits.h"
#include <string.h>

int dem_touching_rows_pay(const struct dem_state *state, const struct dem_effect_list *effects)
{
    return state->contacts.rows.few_touch && !effects->pair.with_wall && !effects->past_touching
           && !effects->scalars && !state->energy_balance->open;
}

/* The rows that touch, and those whose distance is not a number; the margin is for rounding. Each row is
   written, and the number advances only if it touches. */
DEM_KERNEL
static int select_touching(const struct dem_pairs *s, const struct dem_particle *record,
                           const struct dem_row_partners *restrict partners, int rows,
                           uint16_t *restrict touching)
{
    const dem_vec4 sign = {-1.0, -1.0, -1.0, 1.0};
    int n = 0;

    for (int c = 0; c < rows; c++)
    {
        const struct dem_particle *const i = &record[partners[c].i],
                                         *const j = &record[partners[c].j & DEM_RECORD_OF_J];
        const dem_vec4 d = DEM_VEC4(i->x) + sign*DEM_VEC4(j->x)
                         + DEM_VEC4(s->shift[partners[c].j >> DEM_PARTNER_SHIFT]);
        const dem_vec4 square = d*d;

        __builtin_prefetch(record[partners[c + DEM_ROWS_AHEAD].j & DEM_RECORD_OF_J].x);
        touching[n] = (uint16_t)c;
        n += !(square[0] + square[1] + square[2] > square[3]*(1.0 + 0x1p-40));
    }
    return n;
}

/* Columns of the history of touching rows: out of the rows, which are cleared, and back. Lanes past the last
   row have none. */
static void take_history(const struct dem_contact_history *h, uint32_t row, int rows,
                         const uint16_t *touching, int n, double (*column)[DEM_STRETCH_ROWS])
{
    for (int m = 0; m < h->columns; m++)
    {
        double *const from = h->column[m] + row;

        for (int k = 0; k < n; k++)
        {
            column[m][k] = from[touching[k]];
        }
        for (int k = n; k%DEM_LANES; k++)
        {
            column[m][k] = 0.0;
        }
        memset(from, 0, (size_t)rows*sizeof *from);
    }
}

static void give_history(const struct dem_contact_history *h, uint32_t row, const uint16_t *touching,
                         int n, double (*column)[DEM_STRETCH_ROWS])
{
    for (int m = 0; m < h->columns; m++)
    {
        for (int k = 0; k < n; k++)
        {
            h->column[m][row + touching[k]] = column[m][k];
        }
    }
}

static void check_record(struct dem_state *state, const struct dem_contact_workspace *t, uint32_t row,
                         const uint16_t *touching, int rows)
{
    uint32_t pair[DEM_BATCH_ROWS];

    for (int k = 0; k < rows; k++)
    {
        pair[k] = state->contacts.rows.pair[row + touching[k]];
    }
    dem_limits_check_record(state, t, pair, rows);
}

void dem_touching_rows_sweep(struct dem_state *state, struct dem_contact_workspace *t,
                             const struct dem_effect_list *effects, uint32_t row, int rows,
                             const struct dem_batch_forces *to)
{
    const struct dem_contact_rows *const r = &state->contacts.rows;
    const struct dem_contact_history *const h = &state->contacts.history;
    struct dem_row_partners partners[DEM_STRETCH_ROWS + DEM_ROWS_AHEAD];
    _Alignas(64) double column[DEM_HISTORY_COLUMNS][DEM_STRETCH_ROWS];
    _Alignas(64) struct dem_contact_force force[DEM_BATCH_ROWS];
    _Alignas(64) struct dem_contact_moment moment[DEM_BATCH_ROWS];
    uint16_t touching[DEM_STRETCH_ROWS];
    struct dem_contact_history batch = {.columns = h->columns};
    const struct dem_batch_forces local = {.force = force, .moment = to->moment ? moment : NULL};
    const int n = select_touching(&state->pairs, state->particles.record, r->partners + row, rows,
                                  touching);

    take_history(h, row, rows, touching, n, column);
    memset(to->force, 0, (size_t)rows*sizeof *to->force);
    if (to->moment)
    {
        memset(to->moment, 0, (size_t)rows*sizeof *to->moment);
    }
    if (n == 0)
    {
        return;
    }
    for (int k = 0; k < dem_contact_batch_lanes(n) + DEM_ROWS_AHEAD; k++)
    {
        partners[k] = r->partners[row + touching[k < n ? k : n - 1]];
    }
    for (int first = 0; first < n; first += DEM_BATCH_ROWS)
    {
        const int lanes = n - first < DEM_BATCH_ROWS ? n - first : DEM_BATCH_ROWS;

        for (int m = 0; m < h->columns; m++)
        {
            batch.column[m] = column[m] + first;
        }
        dem_contact_batch_fill_pairs(t, state, effects, partners + first, lanes);
        dem_contact_effects_apply(t, effects, &batch, 0);
        const int check = dem_store_forces(&t->batch, 0.5, 0, state->limits.overlap, local);

        for (int k = 0; k < lanes; k++)
        {
            to->force[touching[first + k]] = force[k];
        }
        for (int k = 0; to->moment && k < lanes; k++)
        {
            to->moment[touching[first + k]] = moment[k];
        }
        if (check)
        {
            check_record(state, t, row, touching + first, lanes);
        }
    }
    give_history(h, row, touching, n, column);
}
