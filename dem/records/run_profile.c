/*
 * run_profile.c -- collect timers, counts and communication of all ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/run_profile.h"
#include "core/clock.h"
#include "records/totals.h"
#include "records/inventory.h"
#include "records/timers.h"
#include "ranks/collect.h"
#include <math.h>

enum
{
    WORK = DEM_PHASES,    /* s: advancing, without waiting for other ranks */
    PROCESSOR,            /* s: processor time */
    SECONDS
};

_Static_assert((int)DEM_PHASES == (int)DEM_PROFILE_PHASES, "dem.h reports all phases");

/* Mean and largest time over the ranks, of each phase, of work and of the processor. */
static void gather_times(const struct dem_state *state, double mean[SECONDS], double max[SECONDS])
{
    dem_timers_end_outside(state->timers);
    dem_timers_seconds(state->timers, mean);
    mean[PROCESSOR] = dem_clock_processor() - state->timers->first_processor;
    mean[WORK] = 0.0;
    for (int k = 0; k < DEM_PHASE_OUTSIDE; k++)
    {
        mean[WORK] += k == DEM_PHASE_AGREE || k == DEM_PHASE_REFRESH ? 0.0 : mean[k];
    }
    for (int k = 0; k < SECONDS; k++)
    {
        max[k] = mean[k];
    }
    dem_collect_max_double(&state->decomposition, max, SECONDS);
    dem_collect_sum_double(&state->decomposition, mean, SECONDS);
    for (int k = 0; k < SECONDS; k++)
    {
        mean[k] /= state->decomposition.ranks;
    }
}

static void gather_counts(const struct dem_state *state, struct dem_profile *f)
{
    const struct dem_traffic *const refreshed = &state->halo.refresh_traffic;
    const struct dem_traffic *const exchanged = &state->halo.in.sent;
    int64_t count[8] = {(int64_t)state->particles.n, dem_totals_touching(state), state->timers->particle_steps,
                        state->timers->row_steps,    refreshed->messages, refreshed->bytes,
                        exchanged->messages, exchanged->bytes};

    dem_collect_sum_int64(&state->decomposition, count, 8);
    f->particles = count[0];
    f->contacts = count[1];
    f->particle_steps = count[2];
    f->row_steps = count[3];
    f->messages = count[4];
    f->message_bytes = count[5];
    f->rebuild_messages = count[6];
    f->rebuild_message_bytes = count[7];
}

void dem_profile_take(struct dem_state *state, struct dem_profile *f)
{
    double mean[SECONDS], max[SECONDS];
    struct dem_inventory inventory;

    gather_times(state, mean, max);
    dem_inventory_take(state, &inventory);
    *f = (struct dem_profile){.ranks = state->decomposition.ranks,
                              .outside = mean[DEM_PHASE_OUTSIDE],
                              .imbalance = mean[WORK] > 0.0 ? max[WORK]/mean[WORK] : 1.0,
                              .steps = state->timers->steps,
                              .rebuilds = state->rebuilds - state->timers->rebuilds,
                              .prunes = state->prunes - state->timers->prunes,
                              .outer_skin = 2.0*state->pairs.half_outer,
                              .inner_skin = 2.0*state->pairs.half_inner,
                              .diameter = 2.0*state->pairs.max_radius,
                              .bytes = inventory.bytes,
                              .processor = mean[PROCESSOR]*state->decomposition.ranks,
                             .agreements = state->agreements - state->timers->agreements,
                              .cuts = state->load_balance.cuts};
    for (int k = 0; k < DEM_PHASES; k++)
    {
        f->phase[k].name = dem_phase_name((enum dem_phase)k);
        f->phase[k].mean = mean[k];
        f->phase[k].max = max[k];
        f->wall += mean[k];
    }
    gather_counts(state, f);
    f->largest_overlap = fmax(state->limits.earlier_overlap, state->limits.overlap);
    dem_totals_reduce_max(state, &f->largest_overlap, 1);
}
