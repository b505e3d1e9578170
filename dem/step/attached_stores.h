/*
 * attached_stores.h -- the stores of records and sources that the step fills, attached to the state
 * by pointers.
 *
 * The state (ranks/dem_state.h) lies below records and sources, so it knows their stores by pointer
 * only. Whoever makes a state (the public interface, a timed sample) makes one of these beside it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "records/bonds.h"
#include "records/energy_balance.h"
#include "records/lost_particles.h"
#include "records/timers.h"
#include "records/wall_statistics.h"
#include "sources/flows.h"
#include "records/grid_averages.h"
#include "ranks/dem_state.h"

struct dem_attached_stores
{
    struct dem_grid_averages averages;
    struct dem_flows flows;
    struct dem_lost_particles lost_particles;
    struct dem_bonds bonds;
    struct dem_wall_statistics wall_statistics;
    struct dem_energy_balance energy_balance;
    struct dem_timers timers;
};

/* Let the state use these stores, which are zeroed and have to live as long as it does. */
static inline void dem_attached_stores_attach(struct dem_attached_stores *a,
                                              struct dem_state *state)
{
    state->averages = &a->averages;
    state->flows = &a->flows;
    state->lost_particles = &a->lost_particles;
    state->bonds = &a->bonds;
    state->wall_statistics = &a->wall_statistics;
    state->energy_balance = &a->energy_balance;
    state->timers = &a->timers;
}

/* Free what the stores hold. */
static inline void dem_attached_stores_free(struct dem_attached_stores *a)
{
    dem_grid_averages_free(&a->averages);
    dem_flows_free(&a->flows);
    dem_lost_particles_free(&a->lost_particles);
    dem_bonds_free(&a->bonds);
    dem_wall_statistics_free(&a->wall_statistics);
    dem_energy_balance_free(&a->energy_balance);
}
