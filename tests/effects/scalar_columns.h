/*
 * scalar_columns.h -- particle scalars for batches of a test: values within the limits of their rows,
 * a function of the number of a row.
 *
 *   scalar_columns_contacts(&b, effect);            before rows are filled; rates are 0
 *   scalar_columns_contact_row(effect, to, row)     values of one row
 *
 * and likewise bodies and body_row. There is one set of columns: rates_i() and so on are its results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/random.h"
#include "laws/effect.h"
#include <string.h>

static struct
{
    _Alignas(64) double value[2][DEM_EFFECT_SCALARS][DEM_BATCH_ROWS];
    /* contacts: of i, of j; bodies: rate, coefficient, to_target */
    _Alignas(64) double result[3][DEM_EFFECT_SCALARS][DEM_BATCH_ROWS];
    _Alignas(64) double radius[2][DEM_BATCH_ROWS];
    struct dem_scalar_rows rows[DEM_EFFECT_SCALARS];
    struct dem_scalar_bodies bodies[DEM_EFFECT_SCALARS];
} scalar_columns;

static inline void scalar_columns_clear(void)
{
    memset(&scalar_columns, 0, sizeof scalar_columns);
    for (int k = 0; k < DEM_EFFECT_SCALARS; k++)
    {
        scalar_columns.rows[k] = (struct dem_scalar_rows){.i = scalar_columns.value[0][k],
                                                          .j = scalar_columns.value[1][k],
                                                          .rate_i = scalar_columns.result[0][k],
                                                          .rate_j = scalar_columns.result[1][k],
                                                          .radius_i = scalar_columns.radius[0],
                                                          .radius_j = scalar_columns.radius[1]};
        scalar_columns.bodies[k] =
            (struct dem_scalar_bodies){.value = scalar_columns.value[0][k],
                                       .rate = scalar_columns.result[0][k],
                                       .coefficient = scalar_columns.result[1][k],
                                       .to_target = scalar_columns.result[2][k]};
    }
}

static inline void scalar_columns_contacts(struct dem_contact_batch *b)
{
    scalar_columns_clear();
    b->scalars = scalar_columns.rows;
}

static inline void scalar_columns_bodies(struct dem_body_batch *b)
{
    scalar_columns_clear();
    b->scalars = scalar_columns.bodies;
}

/* Radii from 1 to 2 mm. Values from the smallest one, or 1 % of the largest one below 1000, to that one. */
static inline void scalar_columns_row(const struct dem_effect *e, int to, int row)
{
    for (int side = 0; side < 2; side++)
    {
        scalar_columns.radius[side][to] =
            1e-3*(1.0 + dem_random_unit(2, (uint64_t)row, DEM_EFFECT_SCALARS, (uint64_t)side));
    }
    for (int k = 0; e->scalars && e->scalars[k]; k++)
    {
        const double max = e->scalars[k]->max < 1000.0 ? e->scalars[k]->max : 1000.0;

        for (int side = 0; side < 2; side++)
        {
            scalar_columns.value[side][k][to] =
                max*(0.01 + 0.99*dem_random_unit(2, (uint64_t)row, (uint64_t)k, (uint64_t)side));
        }
    }
}
