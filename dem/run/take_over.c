/*
 * take_over.c -- a run that goes on with an edited scene takes over the records that snapshots do not
 * hold.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "core/error.h"
#include "core/memory.h"
#include "records/energy_balance.h"
#include "records/lost_particles.h"
#include "records/wall_statistics.h"
#include <string.h>

/* Both balances have the same effects in the same order. */
static int same_effects(const struct dem *d, const struct dem *from)
{
    const struct dem_interaction_table *const a = &d->state.interaction_table,
                                       *const b = &from->state.interaction_table;
    int same = a->chosen == b->chosen;

    for (int k = 0; k < a->chosen && same; k++)
    {
        same = a->effect[k] == b->effect[k];
    }
    return same;
}

/* Elastic energies come from this run; everything else goes on. */
static void take_energy(struct dem *d, struct dem *from)
{
    struct dem_energy_balance *const to = d->state.energy_balance,
                              *const was = from->state.energy_balance;

    if (!to->open || !was->open || !same_effects(d, from))
    {
        return;
    }
    const double before = dem_energy_balance_total(&from->state);

    for (int k = 0; k < DEM_ENERGY_BALANCE_SUMS; k++)
    {
        if (k >= DEM_ENERGY_BALANCE_GRAVITY ||
            k%DEM_ENERGY_BALANCE_SUMS_PER_EFFECT != DEM_ENERGY_BALANCE_ELASTIC)
        {
            to->sum[k] = was->sum[k];
        }
    }
    to->since = was->since;
    to->start = was->start;
    to->edited = was->edited;
    dem_energy_balance_edited(&d->state, before);
}

/* With the forces of the last sweep, for the first half kick. */
static int take_impulses(struct dem *d, struct dem *from)
{
    struct dem_wall_statistics *const was = from->state.wall_statistics,
                               *const to = d->state.wall_statistics;

    if (!was->sum)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_wall_statistics_save_forces(&from->state));
    DEM_TRY(dem_wall_statistics_begin(to, d->state.walls.walls));
    DEM_TRY(DEM_NEW(to->saved, to->walls + 1));
    for (int k = 0; k < d->state.walls.walls; k++)
    {
        const int w = dem_walls_named(&from->state.walls, d->state.walls.wall[k].name);

        if (w < from->state.walls.walls)
        {
            to->sum[k] = was->sum[w];
            to->saved[k] = was->saved[w];
            to->work[k] = was->work[w];
        }
    }
    return DEM_OK;
}

static int take_losses(struct dem_lost_particles *to, const struct dem_lost_particles *was)
{
    DEM_TRY(DEM_GROW(to->loss, to->capacity, to->n + was->n + 1));
    if (was->n > 0)
    {
        memcpy(to->loss + to->n, was->loss, was->n*sizeof *to->loss);
    }
    to->n += was->n;
    to->passages += was->passages;
    return DEM_OK;
}

static int take_bonds(struct dem_bonds *to, const struct dem_bonds *was)
{
    DEM_TRY(DEM_GROW(to->broken, to->capacity, to->n + was->n + 1));
    if (was->n > 0)
    {
        memcpy(to->broken + to->n, was->broken, was->n*sizeof *to->broken);
    }
    to->n += was->n;
    return DEM_OK;
}

int dem_take_over(struct dem *d, struct dem *from)
{
    take_energy(d, from);
    int status = take_impulses(d, from);

    status = status ? status : take_losses(d->state.lost_particles, from->state.lost_particles);
    status = status ? status : take_bonds(d->state.bonds, from->state.bonds);
    return dem_sim_agree(d, status);
}
