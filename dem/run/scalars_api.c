/*
 * scalars_api.c -- particle scalars: what a scene has, their values, and their exchange with a fluid
 * or the program.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "dem_fluid.h"
#include "core/error.h"
#include "records/energy_balance.h"
#include "records/totals.h"
#include "particles/scalars.h"
#include "ranks/collect.h"
#include <string.h>

int dem_scalar_count(const struct dem *d)
{
    return d->state.interaction_table.scalars;
}

static int is_scalar(const struct dem *d, int k)
{
    return k >= 0 && k < d->state.interaction_table.scalars;
}

void dem_scalar_info(const struct dem *d, int k, struct dem_scalar_info *info)
{
    *info = (struct dem_scalar_info){.name = "", .unit = "", .help = ""};
    if (!is_scalar(d, k))
    {
        return;
    }
    const struct dem_scalar *const s = d->state.interaction_table.scalar[k];

    *info = (struct dem_scalar_info){.name = s->name,
                                     .unit = s->unit,
                                     .help = s->help,
                                     .default_value = s->default_value,
                                     .min = s->min,
                                     .max = s->max,
                                     .changes = (s->flags & DEM_SCALAR_RATE) != 0,
                                     .written = (s->flags & DEM_SCALAR_WRITTEN) != 0,
                                     .exchanged = d->state.interaction_table.exchanged[k]};
}

int dem_scalar_index(const struct dem *d, const char *name)
{
    return dem_interaction_table_find_scalar(&d->state.interaction_table, name);
}

double *dem_scalar(struct dem *d, int k)
{
    return is_scalar(d, k) ? dem_scalar_values(&d->state.particles, k) : NULL;
}

static int check_values(const struct dem *d, int k, const double *values)
{
    DEM_TRY(dem_sim_require_sound(d, "dem_set_scalar"));
    DEM_REQUIRE(is_scalar(d, k), DEM_ERROR_INPUT, "dem_set_scalar: there is no scalar %d", k);
    const struct dem_scalar *const s = d->state.interaction_table.scalar[k];

    for (size_t i = 0; i < d->state.particles.n; i++)
    {
        DEM_REQUIRE(values[i] >= s->min && values[i] <= s->max, DEM_ERROR_INPUT,
                    "dem_set_scalar: particle %lld gets %s %g %s; give a number from %g to %g",
                    (long long)d->state.particles.record[i].id, s->name, values[i], s->unit, s->min, s->max);
    }
    return DEM_OK;
}

int dem_set_scalar(struct dem *d, int k, const double *values)
{
    struct dem_state *const state = &d->state;

    DEM_TRY(dem_sim_agree(d, check_values(d, k, values)));
    const double before = state->energy_balance->open ? dem_energy_balance_total(state) : 0.0;

    if (state->particles.n > 0)
    {
        memcpy(dem_scalar_values(&state->particles, k), values, state->particles.n*sizeof *values);
    }
    dem_energy_balance_edited(state, before);
    return DEM_OK;
}

/* ---- exchange -------------------------------------------------------------------------------- */

static double *column(const struct dem *d, int k, enum dem_scalar_column which)
{
    return dem_scalar_exchange_values(&d->state.particles, &d->state.interaction_table, k, which);
}

int dem_scalar_exchange(struct dem *d, int k, struct dem_scalar_exchange *x)
{
    DEM_REQUIRE(is_scalar(d, k) && d->state.interaction_table.exchanged[k], DEM_ERROR_STATE,
                "dem_scalar_exchange: no scalar %d is exchanged; call dem_case_exchange_scalar before "
                "dem_start", k);
    *x = (struct dem_scalar_exchange){.n = d->state.particles.n,
                                      .source = column(d, k, DEM_SCALAR_SOURCE),
                                      .coefficient = column(d, k, DEM_SCALAR_COEFFICIENT),
                                      .target = column(d, k, DEM_SCALAR_TARGET),
                                      .received = column(d, k, DEM_SCALAR_RECEIVED),
                                      .coefficient_time = column(d, k, DEM_SCALAR_TIME),
                                      .response = column(d, k, DEM_SCALAR_RESPONSE),
                                      .carried_over = column(d, k, DEM_SCALAR_CARRIED_OVER)};
    return DEM_OK;
}

int dem_scalar_correct(struct dem *d, int k, const double *target)
{
    struct dem_scalar_exchange x;

    DEM_TRY(dem_scalar_exchange(d, k, &x));
    double *const over = column(d, k, DEM_SCALAR_CARRIED_OVER);
    const double *const to_target = column(d, k, DEM_SCALAR_TARGET_TIME);

    for (size_t i = 0; i < x.n; i++)
    {
        const double time = x.coefficient_time[i];

        over[i] = time > 0.0 ? x.response[i]*(target[i] - to_target[i]/time) : 0.0;
    }
    return DEM_OK;
}

int dem_scalar_total(struct dem *d, int k, double *total)
{
    DEM_REQUIRE(is_scalar(d, k), DEM_ERROR_INPUT, "dem_scalar_total: there is no scalar %d", k);
    *total = dem_totals_scalar(&d->state, k);
    return dem_collect_status(&d->state.decomposition);
}
