/*
 * neighbor_rebuild.c -- rebuild and prune the neighbor lists.
 *
 * A rebuild wraps particles along periodic axes, removes those that have left the domain or reached
 * an outlet, inserts particles of streams, migrates particles to their owners, sorts them, and finds
 * ghosts, pairs and contact rows anew.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/neighbor_rebuild.h"
#include "contacts/wall_rows.h"
#include "core/memory.h"
#include "device/device_steps.h"
#include "particles/uniform_fluid.h"
#include "ranks/agree.h"
#include "ranks/collect.h"
#include "records/energy_balance.h"
#include "records/lost_cause.h"
#include "records/lost_particles.h"
#include "records/totals.h"
#include "sources/flows.h"
#include "sources/residence.h"
#include "step/body_window.h"
#include "step/cell_motion.h"
#include "step/clump_batch.h"
#include "step/sweep_bodies.h"
#include <math.h>

/* Particles that have left the domain are removed at steps that are multiples of this, not when
   lists happen to be rebuilt: the tuning of lists must not change results. */
enum
{
    REMOVAL_STEPS = DEM_FLOW_STEPS
};

/* A particle outside the domain is recorded and removed, or an error. */
static int remove_outside(struct dem_state *state, size_t i)
{
    const struct dem_particle *const q = &state->particles.record[i];
    char cause[DEM_LOST_CAUSE_SIZE];

    DEM_REQUIRE(
        isfinite(q->x[0] + q->x[1] + q->x[2]), DEM_ERROR_NUMBER,
        "the position of particle %lld is not a number at step %lld; check its input and the fluid around it",
        (long long)q->id, (long long)state->steps);
    dem_lost_cause_outside(state, i, cause);
    if (state->energy_balance->open)
    {
        dem_energy_balance_particle_out(state, q, 0.5*state->dt);
    }
    DEM_REQUIRE(
        state->domain.remove, DEM_ERROR_LOST,
        "particle %lld left the domain at (%g %g %g) m at time %g s: %s; enlarge the domain, close it with a wall, or set "
        "domain/leaving remove",
        (long long)q->id, q->x[0], q->x[1], q->x[2], state->time, cause);
    if (state->flows->n > 0)
    {
        DEM_TRY(dem_flows_record_departure(state, DEM_FLOW_DOMAIN, q, 0.5*state->dt));
    }
    return dem_lost_particles_add(state->lost_particles, q, state->time, 1, cause);
}

/* A particle in an outlet is removed only in steps in which outlets are checked. */
static int remove_at_outlet(struct dem_state *state, size_t i, int outlet)
{
    if (state->energy_balance->open)
    {
        dem_energy_balance_particle_out(state, &state->particles.record[i], 0.5*state->dt);
    }
    DEM_TRY(dem_flows_record_departure(state, outlet, &state->particles.record[i], 0.5*state->dt));
    dem_residence_record(state, i);
    return DEM_OK;
}

int dem_neighbor_removal_is_due(const struct dem_state *state)
{
    return !state->domain.remove || state->steps%REMOVAL_STEPS == 0;
}

int dem_neighbor_check_removals(struct dem_state *state, int *removes)
{
    const int outlets_due = dem_flows_due(state) && state->flows->plan->outlets > 0;
    double outside = 0.0;

    *removes = 0;
    if (!outlets_due && (!state->domain.remove || !dem_neighbor_removal_is_due(state)))
    {
        return DEM_OK;
    }
    for (size_t i = 0; i < state->particles.n; i++)
    {
        outside = state->domain.remove && !dem_domain_contains(&state->domain,
                                                               dem_clump_home(&state->particles, i))
                      ? 1.0
                      : outside;
        outside = outlets_due && dem_flows_outlet(state, i) != DEM_FLOW_NONE ? 1.0 : outside;
    }
    DEM_TRY(dem_agree_max(state, DEM_OK, &outside, 1));
    *removes = outside > 0.0;
    return DEM_OK;
}

/* Wrap along periodic axes, then remove the particles outside; `weighted`: their load-balance
   weights as well. */
static int wrap_and_remove(struct dem_state *state, int weighted)
{
    struct dem_particle *const record = state->particles.record;
    const size_t n = state->particles.n;
    int status = DEM_OK;
    uint32_t *order;
    size_t kept = 0;

    DEM_TRY(DEM_NEW(order, n + 1));
    for (size_t i = 0; i < n && !status; i++)
    {
        dem_domain_wrap(&state->domain, &record[i]);
        if (dem_clump_of(&state->particles, i))
        {
            dem_clump_wrap(&state->domain, &state->particles, i);
        }
        const double *const home = dem_clump_home(&state->particles, i);
        const int outlet = dem_flows_outlet(state, i);
        const int absorbed = state->walls.absorbing && !state->flows->asked
                                 ? dem_flows_absorbed(state->flows, &record[i])
                                 : DEM_FLOW_NONE;

        if (absorbed != DEM_FLOW_NONE)
        {
            status = remove_at_outlet(state, i, absorbed);
        }
        else if (outlet != DEM_FLOW_NONE && state->flows->now)
        {
            status = remove_at_outlet(state, i, outlet);
        }
        else if (outlet != DEM_FLOW_NONE || dem_domain_contains(&state->domain, home) ||
                 (!dem_neighbor_removal_is_due(state) &&
                  isfinite(record[i].x[0] + record[i].x[1] + record[i].x[2])))
        {
            order[kept++] = (uint32_t)i;
        }
        else
        {
            status = remove_outside(state, i);
        }
    }
    if (!status && kept < n)
    {
        dem_particles_reorder(&state->particles, order, kept);
        if (weighted)
        {
            dem_load_balance_keep_weights(&state->load_balance, order, kept);
        }
    }
    dem_memory_free(order);
    return status;
}

/* After particles were inserted or removed: the Sauter mean diameter, and what drag laws compute
   from it. */
static void update_uniform_fluid(struct dem_state *state)
{
    const struct dem_uniform_fluid *const f = state->flows->fluid;
    double *const column = dem_column(&state->particles, DEM_COLUMN_MEAN_DIAMETER);

    if (f->given && column)
    {
        const double mean = dem_totals_sauter_diameter(state);

        for (size_t i = 0; i < state->particles.n; i++)
        {
            column[i] = mean;
        }
    }
    if (f->given && dem_column(&state->particles, DEM_COLUMN_FLUID_VELOCITY))
    {
        dem_bodies_window_constants(&state->particles, &state->interaction_table.bodies);
    }
}

/* Insert arrivals, which have the velocity of their stream at this time, and kick them backward by
   half a step, as velocities are half a step behind here. */
static int insert_arrivals(struct dem_state *state)
{
    const size_t first = state->particles.n;
    const struct dem_body_sweep backward = {
        .kick = -0.5*state->dt,
        .clump_flow = state->clumps.flow,
        .energy_balance = state->energy_balance->open ? state->energy_balance : NULL,
        .scalars = {.table = state->interaction_table.listed ? &state->interaction_table : NULL}};
    struct dem_body_pass pass;
    double gravity[3];

    int status = dem_flows_insert(state);

    status = status ? status : dem_index_clumps(state);

    dem_interaction_table_gravity(&state->interaction_table, gravity);

    if (state->dt > 0.0)
    {
        update_uniform_fluid(state);                          /* collective */
        dem_bodies_begin_pass(&pass, &state->particles, &state->interaction_table.bodies,
                              &backward);
        pass.next = first;
        dem_bodies_work_until(&pass, status ? first : state->particles.n);
        /* bodies by gravity only: their slip is off by the drag of half a step, of order h b/M, once */
        for (size_t i = first; dem_column(&state->particles, DEM_COLUMN_CLUMP) && i < state->particles.n; i++)
        {
            dem_clump_fall(&state->particles, i, gravity, -0.5*state->dt);
        }
        dem_domain_constrain(&state->domain, &state->particles);
    }
    return status;
}

/* Collective. Rebalance if it pays, insert arrivals, send all particles to their owners. */
static int migrate(struct dem_state *state, int rebalance, int weighted)
{
    int status = DEM_OK;

    if (rebalance)
    {
        DEM_TRY(dem_decomposition_balance(&state->decomposition, &state->particles,
                                          weighted ? state->load_balance.weight : NULL));
        dem_wall_store_expire(&state->wall_store);
    }
    if (state->flows->arrivals > 0)
    {
        status = insert_arrivals(state);
    }
    else if (state->flows->left)
    {
        update_uniform_fluid(state);
    }
    return dem_halo_migrate(&state->halo, status, &state->particles, &state->contacts);
}

/* Collective. Wrap along periodic axes, and remove particles. */
static int remove_particles(struct dem_state *state, int weighted, int status)
{
    DEM_TRY(dem_agree(state, status ? status : wrap_and_remove(state, weighted)));
    return state->flows->n > 0 && (state->steps%REMOVAL_STEPS == 0 || state->flows->left)
               ? dem_flows_sum_departures(state)
               : DEM_OK;
}

int dem_neighbor_change_particles(struct dem_state *state)
{
    state->lists_state = DEM_NEIGHBORS_NONE;
    DEM_TRY(remove_particles(state, 0, DEM_OK));
    return migrate(state, 0, 0);
}

int dem_neighbor_prune(struct dem_state *state, int rebuilt)
{
    int status;

    state->prunes++;
    dem_walls_reset_marks(&state->walls, DEM_LIST_INNER);
    if (state->cell.active)
    {
        dem_cell_list_made(state, DEM_LIST_INNER);
    }
    status = dem_pairs_prune(&state->pairs, &state->particles, &state->walls, &state->contacts);
    if (!status && rebuilt)
    {
        status = dem_contacts_restore_history(&state->contacts, &state->particles,
                                              state->pairs.wall_facet);
    }
    DEM_TRY(dem_agree(state, status));
    dem_wall_touches_set_rows(&state->touches, &state->pairs.wall_search, &state->contacts,
                              &state->interaction_table);
    dem_halo_select_needed(&state->halo, &state->particles, &state->contacts);
    return DEM_OK;
}

/* Count particles, pairs and contact rows; a pair belongs to the owner of its lower id. */
static void count_lists(struct dem_state *state)
{
    const struct dem_contacts *const c = &state->contacts;
    int64_t counted[3] = {(int64_t)state->particles.n, 0, 0};

    for (size_t k = 0; state->pairs.skins.tuned && k < c->pairs.n; k++)
    {
        const int owned = c->pairs.pair[k].i < state->particles.n;

        counted[1] += owned;
        counted[2] += owned && c->pairs.pair[k].row != DEM_ROW_NONE;
    }
    if (state->pairs.skins.tuned)
    {
        dem_collect_sum_int64(&state->decomposition, counted, 3);
    }
    dem_skins_count(&state->pairs.skins, counted);
}

/* Collective. The triangles that the particles of this rank may reach (reach [m]: past touching), and
   their grid. */
static int hold_triangles(struct dem_state *state, int status, double reach)
{
    struct dem_wall_search *const s = &state->pairs.wall_search;
    int changed;

    status = dem_wall_store_select(&state->wall_store, status, &state->walls, &state->particles,
                                   state->pairs.max_radius + reach, &changed);
    return status || !changed ? status : dem_wall_search_prepare(s, &state->walls, s->radius);
}

/* Collective. The outer list of pairs, and from it the contact rows with their history. `status` is what the
   migration returned on this rank; the ranks agree on it here. */
static int build_lists(struct dem_state *state, int status)
{
    dem_pairs_use_chosen_skin(&state->pairs);
    const double reach = state->pairs.outer + (state->device ? dem_device_ghost_reach(state) : 0.0);

    dem_walls_wrap(&state->walls);
    status = hold_triangles(state, status, reach);
    status = status ? status : dem_pairs_order(&state->pairs, &state->particles);
    status = status || !dem_column(&state->particles, DEM_COLUMN_CLUMP) ? status : dem_index_clumps(state);
    status = dem_halo_build(&state->halo, status, &state->particles, &state->domain,
                            state->pairs.max_radius, reach);
    status = status ? status
                    : dem_pairs_find(&state->pairs, &state->domain, &state->particles,
                                     &state->walls, &state->interaction_table, &state->contacts);
    status = status ? status : dem_halo_reserve_needed(&state->halo, &state->particles);
    status = status ? status : dem_wall_touches_reserve(&state->touches, &state->pairs.wall_search);
    DEM_TRY(dem_agree(state, status));
    dem_walls_reset_marks(&state->walls, DEM_LIST_OUTER);
    if (state->cell.active)
    {
        dem_cell_list_made(state, DEM_LIST_OUTER);
    }
    DEM_TRY(dem_neighbor_prune(state, 1));
    count_lists(state);
    return DEM_OK;
}

int dem_neighbor_rebuild(struct dem_state *state)
{
    const int rebalance = dem_load_balance_pays(&state->load_balance, &state->decomposition),
              weighted = rebalance && state->lists_state != DEM_NEIGHBORS_NONE;
    dem_clumps_store(&state->clumps, &state->particles);

    int status = weighted
                     ? dem_load_balance_set_weights(&state->load_balance, &state->particles,
                                                    &state->contacts)
                     : DEM_OK;

    status = status ? status
                    : dem_contacts_save_history(&state->contacts, &state->particles,
                                                state->pairs.wall_facet);
    if (state->cell.active)
    {
        dem_cell_reduce_offset(state);
    }
    DEM_TRY(remove_particles(state, weighted, status));
    DEM_TRY(build_lists(state, migrate(state, rebalance, weighted)));
    state->lists_state = DEM_NEIGHBORS_VALID;
    state->rebuilds++;
    return DEM_OK;
}
