/*
 * setup.c -- start a case: make the run that it describes.
 *
 * 1. Read the scene, add the walls of the program, check all that needs no particles
 *    (setup_read.c, setup_check.c).
 * 2. Create the particles, or read them from a snapshot (setup_particles.c); finish the physics,
 *    the contact storage and skins.
 * 3. Send particles to their owners; without a snapshot, build the first lists, refuse overlaps,
 *    and compute first forces.
 * 4. Energy balance, averages, timers, device.
 *
 * With a snapshot the physics is finished after its particles have been read, which bring their own
 * radii.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/dem_case.h"
#include "case/restart.h"
#include "case/scene_cell.h"
#include "core/error.h"
#include "core/memory.h"
#include "records/snapshot.h"
#include "case/bond_pairs.h"
#include "device/device_steps.h"
#include "records/totals.h"
#include "particles/orientation.h"
#include "ranks/collect.h"
#include "records/wall_wear.h"
#include "step/body_window.h"
#include "step/neighbor_rebuild.h"
#include "step/sum_contacts.h"
#include "step/sweep_contacts.h"
#include "step/wall_bodies.h"
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Initial outer and inner skin [m]: thin, as suits a bed at rest; fast particles make them
   thicker at once. *max is the upper bound of both: a diameter, and in a periodic domain less
   than where a particle would find its own image. */
static void choose_skins(const struct dem_state *state, double radius, double skin[2], double *max)
{
    double min_radius = radius;

    for (int m = 0; m < DEM_MATERIALS; m++)
    {
        min_radius = state->interaction_table.min_radius[m] > 0.0
                       ? fmin(min_radius, state->interaction_table.min_radius[m])
                       : min_radius;
    }
    *max = 2.0*radius;
    for (int k = 0; k < 3; k++)
    {
        *max = state->domain.periodic[k]
                 ? fmin(*max,
                        0.99*(state->domain.length[k] - 2.0*radius - state->interaction_table.reach))
                 : *max;
    }
    min_radius = fmax(min_radius, 0.05*radius);
    skin[0] = fmin(0.15*2.0*min_radius, *max);
    skin[1] = fmin(0.02*2.0*min_radius, skin[0]);
}

/* A restarted run takes the skins of its snapshot: they decide when particles are sorted anew,
   and the order of particles is the order in which a coupled fluid sums them. Other bounds
   (other particles, or skins fixed by the scene) start anew. */
static void resume_skins(struct dem_skins *s, const struct dem_skins *saved)
{
    _Static_assert(sizeof *s <= DEM_SNAPSHOT_SKIN_TUNING*sizeof(int64_t),
                   "a snapshot has space for the state of the skins");

    if (saved->tuned == 1 && saved->min == s->min && saved->max == s->max
        && dem_skins_are_valid(saved))
    {
        *s = *saved;
    }
}

static int prepare_physics(struct dem_case *c)
{
    struct dem *const d = c->d;
    struct dem_state *const state = &d->state;

    if (c->load_path[0])
    {
        DEM_TRY(dem_sim_find_radii(d));
        DEM_TRY(dem_sim_agree(d, dem_sim_add_radii(c)));
        DEM_TRY(dem_sim_finish_physics(d));
    }
    DEM_TRY(dem_sim_insert_new_groups(c));
    const double radius = dem_sim_max_radius(d);
    double skin[2] = {2.0*radius*d->scene.outer_skin, 2.0*radius*d->scene.inner_skin};
    double max_skin = 2.0*radius;

    if (d->scene.tuned_skins)
    {
        choose_skins(state, radius, skin, &max_skin);
    }

    DEM_TRY(dem_wall_store_distribute(&state->wall_store, &state->walls));
    DEM_TRY(dem_contacts_init(&state->contacts, &state->interaction_table));
    state->contacts.forces.all_rows |= c->virial || d->scene.averages > 0 || state->cell.active;
    dem_pairs_init(&state->pairs, &state->domain, skin, state->interaction_table.reach, radius);
    if (d->scene.tuned_skins && radius > 0.0)
    {
        dem_pairs_tune(&state->pairs, max_skin);
        resume_skins(&state->pairs.skins, &c->snapshot_skins);
    }
    return dem_wall_search_prepare(&state->pairs.wall_search, &state->walls, radius > 0.0 ? radius : 1.0);
}

static int read_contacts(struct dem_case *c)
{
    struct dem_state *const state = &c->d->state;
    struct dem_snapshot_facets facets;
    int status = dem_sim_agree(c->d, dem_sim_map_facets(c, &facets));

    status = status ? status
                    : dem_snapshot_read_contacts(c->load_path, &state->decomposition,
                                                 &state->interaction_table, &state->particles, &facets,
                                                 &state->contacts);
    dem_memory_free(facets.wall);
    return status;
}

/* Send particles to their owners. Without a snapshot also build the first lists, refuse
   overlaps, and compute the forces with which the first half kick begins; a snapshot holds them. */
static int distribute(struct dem_case *c)
{
    struct dem *const d = c->d;
    struct dem_state *const state = &d->state;

    DEM_TRY(
        dem_collect_agree(&state->decomposition, dem_domain_project_all(&state->domain, &state->particles)));
    DEM_TRY(dem_decomposition_balance(&state->decomposition, &state->particles, NULL));
    DEM_TRY(dem_collect_agree(&state->decomposition, dem_halo_migrate(&state->halo, DEM_OK, &state->particles,
                                                                      &state->contacts)));
    state->lists_state = DEM_NEIGHBORS_NONE;
    dem_walls_move(&state->walls, state->time, 0.0);
    if (c->load_path[0])
    {
        return read_contacts(c);
    }
    DEM_TRY(dem_neighbor_rebuild(state));
    state->lists_state = DEM_NEIGHBORS_REBUILD;
    DEM_TRY(dem_collect_agree(&state->decomposition, dem_sim_refuse_overlap(d)));
    DEM_TRY(dem_bond_pairs_mark(state, d->scene.bond_ids, d->scene.bond_id_count));
    DEM_TRY(dem_sweep_contacts_and_sum(state, 0.0, (const double[2]){-INFINITY, state->time}));
    dem_sum_bond_energies(&state->particles, &state->contacts);
    state->limits.overlap = 0.0;
    return state->walls.bodies > 0 ? dem_wall_bodies_sum(state) : DEM_OK;
}

static int begin_energy(struct dem *d)
{
    struct dem_state *const state = &d->state;
    int status =
        dem_sweep_contacts_and_bodies(state, 0.0, (const double[2]){state->time, state->time}, NULL);

    status = dem_collect_agree(&state->decomposition, status);
    if (!status)
    {
        dem_energy_balance_begin(state);
    }
    return status;
}

/* The energy that contacts hold at the start. Without a snapshot the first sweep has measured
   it. With one, the contacts are swept once on a backup. */
static int begin_energy_balance(struct dem_case *c)
{
    struct dem *const d = c->d;

    if (!c->load_path[0])
    {
        dem_flows_backup(d->state.flows);
        dem_energy_balance_begin(&d->state);
        return DEM_OK;
    }
    return dem_sim_with_lists(d, begin_energy);
}

/* Sums of the averages when the snapshot was written. The snapshot of the scene's entry `start`
   gives particles only. */
static int resume_averages(struct dem_case *c)
{
    struct dem *const d = c->d;
    void *bytes;
    size_t size;

    if (!c->load_path[0] || c->scene_start || d->state.averages->grids == 0
        || d->state.decomposition.rank > 0)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_snapshot_read_caller_data(c->load_path, &bytes, &size));
    const int status = dem_grid_averages_restore(d->state.averages, c->load_path, bytes, size);

    dem_memory_free(bytes);
    return status;
}

/* Asked for, or needed by an effect that makes heat of what contacts dissipate. */
static int has_energy_balance(const struct dem_case *c)
{
    return c->energy || c->d->state.interaction_table.needs & DEM_NEEDS_DISSIPATION;
}

static int begin_averages(struct dem_case *c)
{
    struct dem *const d = c->d;

    for (int k = 0; k < d->scene.averages; k++)
    {
        d->scene.average[k].comment = d->heading;
    }
    DEM_TRY(dem_sim_agree(d, dem_grid_averages_init(d->state.averages, d->scene.average,
                                                    d->scene.averages,
                                                    &d->state.interaction_table, d->state.time,
                                                    d->state.decomposition.rank == 0)));
    return dem_sim_agree(d, resume_averages(c));
}

/* Ranks read different parts of a snapshot, so one may fail alone. */
static int place_particles(struct dem_case *c)
{
    struct dem *const d = c->d;

    DEM_TRY(dem_sim_agree(d, dem_sim_create_particles(c)));
    dem_orientation_begin(&d->state.particles);
    DEM_TRY(dem_sim_agree(d, prepare_physics(c)));
    DEM_TRY(dem_sim_agree(d, dem_sim_begin_clumps(d)));
    DEM_TRY(dem_sim_agree(d, dem_sim_position_mesh_walls(d)));
    if (d->scene.fluid.given || !c->load_path[0])
    {
        dem_sim_init_fluid(d);
    }
    if (has_energy_balance(c))
    {
        int status = dem_energy_balance_open(d->state.energy_balance, &d->state.interaction_table);

        status = status ? status
                        : dem_energy_balance_watch_walls(d->state.energy_balance, &d->state.walls);
        DEM_TRY(dem_sim_agree(d, status));
    }
    DEM_TRY(dem_sim_agree(d, dem_wall_wear_begin(&d->state)));
    DEM_TRY(dem_sim_agree(d, dem_sim_resume_wear(c)));
    DEM_TRY(dem_sim_agree(d, dem_sim_begin_flows(c)));
    DEM_TRY(dem_sim_agree(d, distribute(c)));
    DEM_TRY(dem_sim_agree(d, dem_sim_check_start(c)));
    return dem_sim_agree(d, dem_sim_check_inserted(c));
}

/* The device of the scene, or a sentence why the CPU makes the steps. */
static void begin_device(struct dem *d)
{
    char why[400];

    if (strcmp(d->scene.device, "cpu") == 0)
    {
        return;
    }
    dem_device_refusal(&d->state, why, sizeof why);
    if (why[0])
    {
        snprintf(d->device, sizeof d->device, "the CPU makes all steps, not device %s: %s",
                 d->scene.device, why);
    }
    else if (dem_device_begin(&d->state, d->scene.device) != DEM_OK)
    {
        snprintf(d->device, sizeof d->device, "the CPU makes all steps, not device %s: %.800s",
                 d->scene.device, dem_error_text());
    }
    else
    {
        snprintf(d->device, sizeof d->device, "%s", dem_device_name(d->state.device));
    }
}

static int set_up(struct dem_case *c)
{
    struct dem *const d = c->d;

    DEM_TRY(c->checked ? DEM_OK : dem_sim_read_scene(c));
    DEM_TRY(place_particles(c));
    DEM_TRY(dem_cell_refuse_fixed(&d->state));
    d->driven = dem_totals_any_driven(&d->state);
    if (has_energy_balance(c))
    {
        DEM_TRY(dem_sim_agree(d, begin_energy_balance(c)));
    }
    /* drag laws of the interrupted window take the fluid columns as loaded */
    if (d->state.window.half_step_ahead)
    {
        dem_bodies_window_constants(&d->state.particles, &d->state.interaction_table.bodies);
    }
    DEM_TRY(begin_averages(c));
    dem_timers_begin(d->state.timers, d->state.rebuilds, d->state.prunes, d->state.agreements);
    d->state.halo.refresh_traffic = d->state.halo.in.sent = (struct dem_traffic){0, 0};
    begin_device(d);
    return DEM_OK;
}

/* The library checks for numbers that are not finite itself. */
static int set_up_without_traps(struct dem_case *c)
{
    fenv_t caller;

    DEM_REQUIRE(c->checked >= 0, DEM_ERROR_STATE, "dem_start after a dem_case_check that failed; "
                "start again with another case");
    DEM_REQUIRE(c->d->dict, DEM_ERROR_STATE, "dem_start comes after the scene has been read");
    feholdexcept(&caller);
    const int status = set_up(c);

    fesetenv(&caller);
    return status;
}

int dem_start(struct dem_case **consumed, struct dem **started)
{
    struct dem_case *const c = *consumed;
    const int status = set_up_without_traps(c);

    *consumed = NULL;
    *started = NULL;
    if (!status)
    {
        *started = c->d;
        c->d = NULL;
    }
    dem_case_free(c);
    return status;
}
