/*
 * neighbor_update.c -- phase 3 of a step: receive the ghosts, and prune or rebuild the neighbor
 * lists when their skins are used up.
 *
 * Ghosts are sent in step.c and received here, except in a step that rebuilds: it makes new ghosts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/neighbor_update.h"
#include "device/device_steps.h"
#include "ranks/agree.h"
#include "records/timers.h"
#include "sources/flows.h"
#include "step/neighbor_rebuild.h"
#include <math.h>

/* ---- when ------------------------------------------------------------------------------------ */

/* How much of a skin [m] is used up: bound on how much closer two particles, or a particle and a
   wall, have come, when particles have moved by `further` since displacements were added. */
static double used(const struct dem_state *state, enum dem_list list, double further)
{
    const struct dem_displacement *const d = &state->pairs.displacement[list];
    const double spread = d->spread + further;

    if (d->deforms)
    {
        /* no walls there; displacements are of the lengths when the list was made */
        return 2.0*spread*(1.0 + d->strain)
             + d->strain*(2.0*state->pairs.max_radius + state->pairs.outer
                          + state->interaction_table.reach);
    }
    return spread + fmax(spread, dem_walls_max_displacement(&state->walls, list, d->centre));
}

int dem_neighbor_agreement_due(const struct dem_state *state, double moved)
{
    int due = state->lists_state != DEM_NEIGHBORS_VALID || dem_flows_due(state) ||
    (state->domain.remove && dem_neighbor_removal_is_due(state));

    for (enum dem_list l = 0; l < DEM_LISTS && !due; l++)
    {
        due = !(used(state, l, moved) <= state->pairs.displacement[l].skin);
    }
    return due;
}

/* The bound is exhausted: measure the displacements since the list was built. Along an axis that is
   periodic or unbounded, a common displacement of all particles is subtracted; along an axis with a
   finite, non-periodic boundary displacements count in full. */
static int measure_displacements(struct dem_state *state, enum dem_list list)
{
    struct dem_displacement *const d = &state->pairs.displacement[list];
    double max[DEM_DISPLACEMENT_NUMBERS], centre[3], spread;
    int free[3];

    for (int k = 0; k < 3; k++)
    {
        free[k] =
            state->domain.periodic[k] ||
            !(isfinite(state->domain.min[k]) || isfinite(state->domain.max[k]));
    }
    dem_displacement_extent(d, &state->particles, max);
    DEM_TRY(dem_agree_max(state, DEM_OK, max, DEM_DISPLACEMENT_NUMBERS));
    if (!dem_displacement_set_extent(d, max, free, centre))
    {
        return DEM_OK;
    }
    spread = dem_displacement_spread(d, &state->particles, centre);
    DEM_TRY(dem_agree_max(state, DEM_OK, &spread, 1));
    dem_displacement_set(d, spread, centre);
    return DEM_OK;
}

/* 1 when particles may lie outside of a periodic box by more than half a skin and their positions
   are read after the step (`observed`), or by more than half a box at any time. */
static int needs_wrap(const struct dem_state *state, int observed)
{
    const struct dem_displacement *const d = &state->pairs.displacement[DEM_LIST_OUTER];
    int needs = 0;

    for (int k = 0; k < 3; k++)
    {
        const double distance = fabs(d->centre[k]) + d->spread;

        needs |= state->domain.periodic[k] && d->centre[k] != 0.0
                 && distance > (observed ? state->pairs.half_outer : 0.5*state->domain.length[k]);
    }
    return needs;
}

/* Measure displacements for the lists whose bound is exhausted, or for both. `expired`: 1 for each
   list whose skin is used up. */
static int check_lists(struct dem_state *state, int both, int expired[DEM_LISTS])
{
    for (enum dem_list l = 0; l < DEM_LISTS; l++)
    {
        const double skin = state->pairs.displacement[l].skin;

        expired[l] = used(state, l, 0.0) > skin;
        if (expired[l] || both)
        {
            DEM_TRY(measure_displacements(state, l));
            expired[l] = used(state, l, 0.0) > skin;
            if (expired[l] || both)
            {
                dem_skins_choose(&state->pairs.skins, l, 0.5*used(state, l, 0.0));
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

int dem_neighbor_check_particles(struct dem_state *state, int *changes)
{
    *changes = state->flows->found;
    if (state->flows->found)
    {
        state->flows->found = 0;
        return DEM_OK;
    }
    state->flows->now = dem_flows_due(state);
    if (state->flows->now || (state->domain.remove && dem_neighbor_removal_is_due(state)))
    {
        dem_clumps_store(&state->clumps, &state->particles);
    }
    DEM_TRY(state->flows->now ? dem_flows_count_passages(state, 0.5*state->dt) : DEM_OK);
    DEM_TRY(dem_neighbor_check_removals(state, changes));
    state->flows->left = *changes;
    if (state->flows->now && state->flows->plan->streams > 0)
    {
        DEM_TRY(dem_agree(state, dem_flows_find_positions(state, state->steps)));
        *changes |= state->flows->arrivals > 0;
    }
    return DEM_OK;
}

static int update_lists(struct dem_state *state, const double *moved, int n, int observed)
{
    struct dem_pairs *const s = &state->pairs;
    int changes, expired[DEM_LISTS] = {0, 0};

    DEM_TRY(dem_neighbor_check_particles(state, &changes));
    if (state->lists_state == DEM_NEIGHBORS_VALID && !state->contacts_on_device)
    {
        const int both = add_displacements(s, moved, n);

        DEM_TRY(check_lists(state, both, expired));
        expired[DEM_LIST_OUTER] |=
            needs_wrap(state, observed) || (both && dem_skins_pays(&s->skins, DEM_LIST_OUTER));
        expired[DEM_LIST_INNER] |= both && dem_skins_pays(&s->skins, DEM_LIST_INNER);
    }
    dem_timers_end_phase(state->timers, DEM_PHASE_AGREE);
    if (state->lists_state != DEM_NEIGHBORS_VALID || changes || expired[DEM_LIST_OUTER])
    {
        dem_timers_begin_rare_phase(state->timers, DEM_PHASE_AGREE);
        dem_halo_wait(&state->halo);
        DEM_TRY(dem_device_return_contacts(state, 0));
        DEM_TRY(dem_neighbor_rebuild(state));
        state->flows->now = state->flows->left = 0;
        dem_timers_end_rare_phase(state->timers, DEM_PHASE_REBUILD);
        return DEM_OK;
    }
    dem_halo_receive(&state->halo, &state->particles);
    dem_timers_end_phase(state->timers, DEM_PHASE_REFRESH);
    if (expired[DEM_LIST_INNER])
    {
        dem_halo_send(&state->halo, &state->particles, DEM_HALO_ALL);
        dem_halo_receive(&state->halo, &state->particles);
        DEM_TRY(dem_neighbor_prune(state, 0));
        dem_timers_end_phase(state->timers, DEM_PHASE_PRUNE);
    }
    return DEM_OK;
}

/* ---- absorbing walls ------------------------------------------------------------------------- */

/* A rigid body is absorbed as a whole, by the wall that its first marked sphere touches. */
static void mark_bodies(struct dem_state *state)
{
    const struct dem_clumps *const c = &state->clumps;
    struct dem_particle *const record = state->particles.record;

    for (size_t body = 0; body < c->n; body++)
    {
        unsigned mark = 0;

        for (size_t k = c->start[body]; k < c->start[body + 1]; k++)
        {
            mark = mark ? mark : record[c->member[k]].flags & DEM_PARTICLE_ABSORBED;
        }
        for (size_t k = c->start[body]; k < c->start[body + 1] && mark; k++)
        {
            record[c->member[k]].flags =
                (uint16_t)((record[c->member[k]].flags & 0xffu) | mark);
        }
    }
}

/* Mark the particles that touch a wall with `absorb yes`. Returns 1 when this rank has marked any. */
static int mark_absorbed(struct dem_state *state)
{
    const struct dem_wall_search *const s = &state->pairs.wall_search;
    int marked = 0;

    for (size_t k = 0; k < s->neighbors; k++)
    {
        const struct dem_wall_neighbor *const near = &s->neighbor[k];
        const struct dem_wall *const wall =
            &state->walls.wall[state->walls.facet[near->facet].wall];
        struct dem_particle *const q = &state->particles.record[near->particle];

        if (wall->absorbs && !(q->flags & (DEM_PARTICLE_FROZEN | DEM_PARTICLE_ABSORBED))
            && dem_wall_search_distance(s, &state->walls, near, q->x) <= q->radius)
        {
            q->flags = (uint16_t)(q->flags | (wall->outlet + 1) << DEM_PARTICLE_ABSORBED_SHIFT);
            marked = 1;
        }
    }
    mark_bodies(state);
    return marked;
}

/* Collective. Remove in this step what touches an absorbing wall, before contacts are computed; in
   coupled runs dem_flows_between_windows does it, and until then the particle rebounds. Lists of
   this step are the same on any number of ranks. */
static int absorb(struct dem_state *state)
{
    double marked = mark_absorbed(state);

    if (state->flows->asked)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_agree_max(state, DEM_OK, &marked, 1));
    if (marked > 0.0)
    {
        state->flows->left = 1;
        DEM_TRY(dem_neighbor_rebuild(state));
        state->flows->left = 0;
    }
    return DEM_OK;
}

int dem_neighbor_update(struct dem_state *state, const double *moved, int n, int observed)
{
    if (n > 0)
    {
        const int checked = dem_flows_due(state);

        DEM_TRY(update_lists(state, moved, n, observed));
        if (checked)
        {
            dem_flows_end_check(state);
        }
    }
    else
    {
        dem_timers_end_phase(state->timers, DEM_PHASE_AGREE);
        dem_halo_receive(&state->halo, &state->particles);
        dem_timers_end_phase(state->timers, DEM_PHASE_REFRESH);
    }
    /* the device finds what touches its walls */
    return state->walls.absorbing && !state->contacts_on_device ? absorb(state) : DEM_OK;
}

int dem_neighbor_take_back(struct dem_state *state)
{
    dem_timers_begin_rare_phase(state->timers, DEM_PHASE_AGREE);
    DEM_TRY(dem_device_return_contacts(state, 0));
    DEM_TRY(dem_neighbor_rebuild(state));
    dem_timers_end_rare_phase(state->timers, DEM_PHASE_REBUILD);
    return state->walls.absorbing ? absorb(state) : DEM_OK;
}
