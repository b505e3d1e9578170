/*
 * neighbor_update.c -- decide when neighbor lists are pruned or rebuilt, and rebuild them.
 *
 * A rebuild wraps particles along periodic axes, removes those that have left the domain or reached
 * an outlet, inserts particles of streams, migrates particles to their owners, sorts them, and finds
 * ghosts, pairs and contact rows anew.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/neighbor_update.h"
#include "core/memory.h"
#include "ranks/agree.h"
#include "records/lost_cause.h"
#include "particles/uniform_fluid.h"
#include "contacts/wall_rows.h"
#include "records/energy_balance.h"
#include "records/lost_particles.h"
#include "sources/flows.h"
#include "records/totals.h"
#include "step/body_window.h"
#include "step/sweep_bodies.h"
#include "records/timers.h"
#include "ranks/collect.h"
#include <math.h>

/* Particles that have left the domain are removed at steps that are multiples of this, not when
   lists happen to be rebuilt: the tuning of lists must not change results. */
enum
{
    REMOVAL_STEPS = DEM_FLOW_STEPS
};

/* ---- rebuilding ------------------------------------------------------------------------------ */

/* A particle outside the domain is recorded and removed, or an error. */
static int remove_outside(struct dem_state *p, size_t i)
{
    const struct dem_particle *const q = &p->particles.record[i];
    char cause[DEM_LOST_CAUSE_SIZE];

    DEM_REQUIRE(
        isfinite(q->x[0] + q->x[1] + q->x[2]), DEM_ERROR_NUMBER,
        "the position of particle %lld is not a number at step %lld; check its input and the fluid around it",
        (long long)q->id, (long long)p->steps);
    dem_lost_cause_outside(p, i, cause);
    if (p->energy_balance->open)
    {
        dem_energy_balance_particle_out(p, q, 0.5*p->dt);
    }
    DEM_REQUIRE(
        p->domain.remove, DEM_ERROR_LOST,
        "particle %lld left the domain at (%g %g %g) m at time %g s: %s; enlarge the domain, close it with a wall, or set "
        "domain/leaving remove",
        (long long)q->id, q->x[0], q->x[1], q->x[2], p->time, cause);
    if (p->flows->n > 0)
    {
        DEM_TRY(dem_flows_record_departure(p, DEM_FLOW_DOMAIN, q, 0.5*p->dt));
    }
    return dem_lost_particles_add(p->lost_particles, q, p->time, 1, cause);
}

/* A particle in an outlet is removed only in steps in which outlets are checked. */
static int remove_at_outlet(struct dem_state *p, size_t i, int outlet)
{
    if (p->energy_balance->open)
    {
        dem_energy_balance_particle_out(p, &p->particles.record[i], 0.5*p->dt);
    }
    return dem_flows_record_departure(p, outlet, &p->particles.record[i], 0.5*p->dt);
}

static int removal_is_due(const struct dem_state *p)
{
    return !p->domain.remove || p->steps%REMOVAL_STEPS == 0;
}

/* `removes`: 1 on all ranks when any particle has to be removed now. */
static int check_removals(struct dem_state *p, int *removes)
{
    const int outlets_due = dem_flows_due(p) && p->flows->plan->outlets > 0;
    double outside = 0.0;

    *removes = 0;
    if (!outlets_due && (!p->domain.remove || !removal_is_due(p)))
    {
        return DEM_OK;
    }
    for (size_t i = 0; i < p->particles.n; i++)
    {
        const struct dem_particle *const q = &p->particles.record[i];

        outside = p->domain.remove && !dem_domain_contains(&p->domain, q->x) ? 1.0 : outside;
        outside = outlets_due && dem_flows_outlet(p, i) != DEM_FLOW_NONE ? 1.0 : outside;
    }
    DEM_TRY(dem_agree_max(p, DEM_OK, &outside, 1));
    *removes = outside > 0.0;
    return DEM_OK;
}

/* Wrap along periodic axes, then remove the particles outside; `weighted`: their load-balance
   weights as well. */
static int wrap_and_remove(struct dem_state *p, int weighted)
{
    struct dem_particle *const record = p->particles.record;
    const size_t n = p->particles.n;
    int status = DEM_OK;
    uint32_t *order;
    size_t kept = 0;

    DEM_TRY(DEM_NEW(order, n + 1));
    for (size_t i = 0; i < n && !status; i++)
    {
        dem_domain_wrap(&p->domain, &record[i]);
        const int outlet = dem_flows_outlet(p, i);
        const int absorbed = p->walls.absorbing && !p->flows->asked
                                 ? dem_flows_absorbed(p->flows, &record[i])
                                 : DEM_FLOW_NONE;

        if (absorbed != DEM_FLOW_NONE)
        {
            status = remove_at_outlet(p, i, absorbed);
        }
        else if (outlet != DEM_FLOW_NONE && p->flows->now)
        {
            status = remove_at_outlet(p, i, outlet);
        }
        else if (outlet != DEM_FLOW_NONE || dem_domain_contains(&p->domain, record[i].x) ||
                 (!removal_is_due(p) && isfinite(record[i].x[0] + record[i].x[1] + record[i].x[2])))
        {
            order[kept++] = (uint32_t)i;
        }
        else
        {
            status = remove_outside(p, i);
        }
    }
    if (!status && kept < n)
    {
        dem_particles_reorder(&p->particles, order, kept);
        if (weighted)
        {
            dem_load_balance_keep_weights(&p->load_balance, order, kept);
        }
    }
    dem_memory_free(order);
    return status;
}

/* After particles were inserted or removed: the Sauter mean diameter, and what drag laws compute
   from it. */
static void update_uniform_fluid(struct dem_state *p)
{
    const struct dem_uniform_fluid *const f = p->flows->fluid;
    double *const column = dem_column(&p->particles, DEM_COLUMN_MEAN_DIAMETER);

    if (f->given && column)
    {
        const double mean = dem_totals_sauter_diameter(p);

        for (size_t i = 0; i < p->particles.n; i++)
        {
            column[i] = mean;
        }
    }
    if (f->given && dem_column(&p->particles, DEM_COLUMN_FLUID_VELOCITY))
    {
        dem_bodies_window_constants(&p->particles, &p->interaction_table.bodies);
    }
}

/* Insert arrivals, which have the velocity of their stream at this time, and kick them backward by
   half a step, as velocities are half a step behind here. */
static int insert_arrivals(struct dem_state *p)
{
    const size_t first = p->particles.n;
    const struct dem_body_sweep backward = {
        .kick = -0.5*p->dt,
        .energy_balance = p->energy_balance->open ? p->energy_balance : NULL,
        .scalars = {.table = p->interaction_table.listed ? &p->interaction_table : NULL}};
    struct dem_body_pass pass;

    const int status = dem_flows_insert(p);

    if (p->dt > 0.0)
    {
        update_uniform_fluid(p);                          /* collective */
        dem_bodies_begin_pass(&pass, &p->particles, &p->interaction_table.bodies, &backward);
        pass.next = first;
        dem_bodies_work_until(&pass, p->particles.n);
        dem_domain_constrain(&p->domain, &p->particles);
    }
    return status;
}

/* Collective. Rebalance if it pays, insert arrivals, send all particles to their owners. */
static int migrate(struct dem_state *p, int rebalance, int weighted)
{
    int status = DEM_OK;

    if (rebalance)
    {
        DEM_TRY(dem_decomposition_balance(&p->decomposition, &p->particles,
                                          weighted ? p->load_balance.weight : NULL));
        dem_wall_store_expire(&p->wall_store);
    }
    if (p->flows->arrivals > 0)
    {
        status = insert_arrivals(p);
    }
    else if (p->flows->left)
    {
        update_uniform_fluid(p);
    }
    return dem_halo_migrate(&p->halo, status, &p->particles, &p->contacts);
}

/* Collective. Contact rows from the pairs of the outer list that are within the inner skin;
   `rebuilt`: with the history saved before a rebuild. */
static int prune(struct dem_state *p, int rebuilt)
{
    int status;

    p->prunes++;
    dem_walls_reset_marks(&p->walls, DEM_LIST_INNER);
    status = dem_pairs_prune(&p->pairs, &p->particles, &p->walls, &p->contacts);
    if (!status && rebuilt)
    {
        status = dem_contacts_restore_history(&p->contacts, &p->particles, p->pairs.wall_facet);
    }
    DEM_TRY(dem_agree(p, status));
    dem_wall_touches_set_rows(&p->touches, &p->pairs.wall_search, &p->contacts,
                              &p->interaction_table);
    dem_halo_select_candidates(&p->halo, &p->particles, &p->contacts);
    return DEM_OK;
}

/* Count particles, pairs and contact rows; a pair belongs to the owner of its lower id. */
static void count_lists(struct dem_state *p)
{
    const struct dem_contacts *const c = &p->contacts;
    int64_t counted[3] = {(int64_t)p->particles.n, 0, 0};

    for (size_t k = 0; p->pairs.skins.tuned && k < c->pairs.n; k++)
    {
        const int owned = c->pairs.pair[k].i < p->particles.n;

        counted[1] += owned;
        counted[2] += owned && c->pairs.pair[k].row != DEM_ROW_NONE;
    }
    if (p->pairs.skins.tuned)
    {
        dem_collect_sum_int64(&p->decomposition, counted, 3);
    }
    dem_skins_count(&p->pairs.skins, counted);
}

/* Collective. The triangles that the particles of this rank may reach, and their grid. */
static int hold_triangles(struct dem_state *p, int status)
{
    struct dem_wall_search *const s = &p->pairs.wall_search;
    int changed;

    status = dem_wall_store_select(&p->wall_store, status, &p->walls, &p->particles,
                                   p->pairs.max_radius + p->pairs.outer, &changed);
    return status || !changed ? status : dem_wall_search_prepare(s, &p->walls, s->radius);
}

/* Collective. The outer list of pairs, and from it the contact rows with their history; `status` is that of the
   migration, on which the ranks agree here. */
static int build_lists(struct dem_state *p, int status)
{
    dem_pairs_use_chosen_skin(&p->pairs);
    dem_walls_wrap(&p->walls);
    status = hold_triangles(p, status);
    status = status ? status : dem_pairs_order(&p->pairs, &p->particles);
    status = dem_halo_build(&p->halo, status, &p->particles, &p->domain, p->pairs.max_radius,
                            p->pairs.outer);
    status = status ? status
                    : dem_pairs_find(&p->pairs, &p->domain, &p->particles, &p->walls,
                                     &p->interaction_table, &p->contacts);
    status = status ? status : dem_halo_reserve_candidates(&p->halo, &p->particles);
    status = status ? status : dem_wall_touches_reserve(&p->touches, &p->pairs.wall_search);
    DEM_TRY(dem_agree(p, status));
    dem_walls_reset_marks(&p->walls, DEM_LIST_OUTER);
    DEM_TRY(prune(p, 1));
    count_lists(p);
    return DEM_OK;
}

int dem_neighbor_rebuild(struct dem_state *p)
{
    const int rebalance = dem_load_balance_pays(&p->load_balance, &p->decomposition),
              weighted = rebalance && p->stale < 2;
    int status = weighted
                     ? dem_load_balance_set_weights(&p->load_balance, &p->particles, &p->contacts)
                     : DEM_OK;

    status = status ? status
                    : dem_contacts_save_history(&p->contacts, &p->particles, p->pairs.wall_facet);
    status = status ? status : wrap_and_remove(p, weighted);
    DEM_TRY(dem_agree(p, status));
    if (p->flows->n > 0 && (p->steps%REMOVAL_STEPS == 0 || p->flows->left))
    {
        DEM_TRY(dem_flows_sum_departures(p));
    }
    DEM_TRY(build_lists(p, migrate(p, rebalance, weighted)));
    p->stale = 0;
    p->rebuilds++;
    return DEM_OK;
}

/* ---- when ------------------------------------------------------------------------------------ */

/* How much of a skin [m] is used up: bound on how much closer two particles, or a particle and a
   wall, have come, when particles have moved by `further` since displacements were added. */
static double used(const struct dem_state *p, enum dem_list list, double further)
{
    const struct dem_displacement *const d = &p->pairs.displacement[list];
    const double spread = d->spread + further;

    return spread + fmax(spread, dem_walls_max_displacement(&p->walls, list, d->centre));
}

int dem_neighbor_agreement_due(const struct dem_state *p, double moved)
{
    int due = p->stale || dem_flows_due(p) || (p->domain.remove && removal_is_due(p));

    for (enum dem_list l = 0; l < DEM_LISTS && !due; l++)
    {
        due = !(used(p, l, moved) <= p->pairs.displacement[l].skin);
    }
    return due;
}

/* The bound is exhausted: measure the displacements since the list was built. Along an axis that is
   periodic or unbounded, a common displacement of all particles is subtracted; along an axis with a
   finite, non-periodic boundary displacements count in full. */
static int measure_displacements(struct dem_state *p, enum dem_list list)
{
    struct dem_displacement *const d = &p->pairs.displacement[list];
    double max[DEM_DISPLACEMENT_NUMBERS], centre[3], spread;
    int free[3];

    for (int k = 0; k < 3; k++)
    {
        free[k] =
            p->domain.periodic[k] || !(isfinite(p->domain.min[k]) || isfinite(p->domain.max[k]));
    }
    dem_displacement_extent(d, &p->particles, max);
    DEM_TRY(dem_agree_max(p, DEM_OK, max, DEM_DISPLACEMENT_NUMBERS));
    if (!dem_displacement_set_extent(d, max, free, centre))
    {
        return DEM_OK;
    }
    spread = dem_displacement_spread(d, &p->particles, centre);
    DEM_TRY(dem_agree_max(p, DEM_OK, &spread, 1));
    dem_displacement_set(d, spread, centre);
    return DEM_OK;
}

/* 1 when particles may lie outside of a periodic box by more than half a skin and their positions
   are read after the step (`observed`), or by more than half a box at any time. */
static int needs_wrap(const struct dem_state *p, int observed)
{
    const struct dem_displacement *const d = &p->pairs.displacement[DEM_LIST_OUTER];
    int needs = 0;

    for (int k = 0; k < 3; k++)
    {
        const double distance = fabs(d->centre[k]) + d->spread;

        needs |= p->domain.periodic[k] && d->centre[k] != 0.0
                 && distance > (observed ? p->pairs.half_outer : 0.5*p->domain.length[k]);
    }
    return needs;
}

/* Measure displacements for the lists whose bound is exhausted, or for both. `stale`: 1 for each
   list whose skin is used up. */
static int check_lists(struct dem_state *p, int both, int stale[DEM_LISTS])
{
    for (enum dem_list l = 0; l < DEM_LISTS; l++)
    {
        const double skin = p->pairs.displacement[l].skin;

        stale[l] = used(p, l, 0.0) > skin;
        if (stale[l] || both)
        {
            DEM_TRY(measure_displacements(p, l));
            stale[l] = used(p, l, 0.0) > skin;
            if (stale[l] || both)
            {
                dem_skins_choose(&p->pairs.skins, l, 0.5*used(p, l, 0.0));
            }
        }
    }
    return DEM_OK;
}

/* Add the displacements of n steps. Returns 1 when it is time to check the skins. */
static int add_displacements(struct dem_pairs *s, const double *moved, int n)
{
    int check = 0;

    for (int k = 0; k < n; k++)
    {
        s->displacement[DEM_LIST_OUTER].spread += moved[k];
        s->displacement[DEM_LIST_INNER].spread += moved[k];
        check |= dem_skins_step(&s->skins, moved[k]);
    }
    return check;
}

static int update_lists(struct dem_state *p, const double *moved, int n, int observed)
{
    struct dem_pairs *const s = &p->pairs;
    int changes, stale[DEM_LISTS] = {0, 0};

    DEM_TRY(check_removals(p, &changes));
    p->flows->left = changes;
    p->flows->now = dem_flows_due(p);
    if (p->flows->now && p->flows->plan->streams > 0)
    {
        DEM_TRY(dem_agree(p, dem_flows_find_positions(p, p->steps)));
        changes |= p->flows->arrivals > 0;
    }
    if (!p->stale)
    {
        const int both = add_displacements(s, moved, n);

        DEM_TRY(check_lists(p, both, stale));
        stale[DEM_LIST_OUTER] |=
            needs_wrap(p, observed) || (both && dem_skins_pays(&s->skins, DEM_LIST_OUTER));
        stale[DEM_LIST_INNER] |= both && dem_skins_pays(&s->skins, DEM_LIST_INNER);
    }
    dem_timers_end_phase(p->timers, DEM_PHASE_AGREE);
    if (p->stale || changes || stale[DEM_LIST_OUTER])
    {
        dem_timers_begin_rare_phase(p->timers, DEM_PHASE_AGREE);
        dem_halo_wait(&p->halo);
        DEM_TRY(dem_neighbor_rebuild(p));
        p->flows->now = p->flows->left = 0;
        dem_timers_end_rare_phase(p->timers, DEM_PHASE_REBUILD);
        return DEM_OK;
    }
    dem_halo_receive(&p->halo, &p->particles);
    dem_timers_end_phase(p->timers, DEM_PHASE_REFRESH);
    if (stale[DEM_LIST_INNER])
    {
        dem_halo_send(&p->halo, &p->particles, DEM_HALO_ALL);
        dem_halo_receive(&p->halo, &p->particles);
        DEM_TRY(prune(p, 0));
        dem_timers_end_phase(p->timers, DEM_PHASE_PRUNE);
    }
    return DEM_OK;
}

/* ---- absorbing walls ------------------------------------------------------------------------- */

/* Mark the particles that touch a wall with `absorb yes`. Returns 1 when this rank has marked any. */
static int mark_absorbed(struct dem_state *p)
{
    const struct dem_wall_search *const s = &p->pairs.wall_search;
    int marked = 0;

    for (size_t k = 0; k < s->neighbors; k++)
    {
        const struct dem_wall_neighbor *const near = &s->neighbor[k];
        const struct dem_wall *const wall = &p->walls.wall[p->walls.facet[near->facet].wall];
        struct dem_particle *const q = &p->particles.record[near->particle];

        if (wall->absorbs && !(q->flags & (DEM_PARTICLE_FROZEN | DEM_PARTICLE_ABSORBED))
            && dem_wall_search_distance(s, &p->walls, near, q->x) <= q->radius)
        {
            q->flags = (uint16_t)(q->flags | (wall->outlet + 1) << DEM_PARTICLE_ABSORBED_SHIFT);
            marked = 1;
        }
    }
    return marked;
}

/* Collective. Remove in this step what touches an absorbing wall, before contacts are computed; in
   coupled runs dem_flows_between_windows does it, and until then the particle rebounds. Lists of
   this step are the same on any number of ranks. */
static int absorb(struct dem_state *p)
{
    double marked = mark_absorbed(p);

    if (p->flows->asked)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_agree_max(p, DEM_OK, &marked, 1));
    if (marked > 0.0)
    {
        p->flows->left = 1;
        DEM_TRY(dem_neighbor_rebuild(p));
        p->flows->left = 0;
    }
    return DEM_OK;
}

int dem_neighbor_update(struct dem_state *p, const double *moved, int n, int observed)
{
    if (n > 0)
    {
        const int checked = dem_flows_due(p);

        DEM_TRY(update_lists(p, moved, n, observed));
        if (checked)
        {
            dem_flows_end_check(p);
        }
    }
    else
    {
        dem_timers_end_phase(p->timers, DEM_PHASE_AGREE);
        dem_halo_receive(&p->halo, &p->particles);
        dem_timers_end_phase(p->timers, DEM_PHASE_REFRESH);
    }
    return p->walls.absorbing ? absorb(p) : DEM_OK;
}
