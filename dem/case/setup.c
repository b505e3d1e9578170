/*
 * setup.c -- set up a simulation from its scene.
 *
 * 1. Read the scene, add the walls of the program, check all that needs no particles
 *    (setup_check.c).
 * 2. Create the particles, or read them from a snapshot (setup_particles.c); finish the physics,
 *    the contact storage and skins.
 * 3. Send particles to their owners; without a snapshot, build the first lists, refuse overlaps,
 *    and compute first forces.
 * 4. Energy balance, averages, timers.
 *
 * With a snapshot the physics is finished after its particles have been read, which bring their own
 * radii.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/restart.h"
#include "core/error.h"
#include "core/memory.h"
#include "records/snapshot.h"
#include "case/bond_pairs.h"
#include "records/totals.h"
#include "particles/orientation.h"
#include "ranks/collect.h"
#include "step/body_window.h"
#include "step/neighbor_rebuild.h"
#include "step/sum_contacts.h"
#include "step/sweep_contacts.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Added mass in the inertia is seen by contact laws; one that counts its own would count it twice. */
static int refuse_added_mass_twice(const struct dem_interaction_table *r)
{
    const struct dem_effect *inertia = NULL;

    for (int k = 0; k < r->chosen; k++)
    {
        inertia = r->effect[k]->has_added_mass ? r->effect[k] : inertia;
    }
    for (int k = 0; k < r->chosen; k++)
    {
        const struct dem_effect *const e = r->effect[k];
        const double added = e->own_added_mass ? e->own_added_mass(r->settings[k]) : 0.0;

        DEM_REQUIRE(
            !(added > 0.0 && inertia), DEM_ERROR_INPUT,
            "effects/%s counts addedMass %g, and %s adds it to the inertia, which %s sees; leave addedMass out",
            e->name, added, inertia->name, e->name);
    }
    return DEM_OK;
}

/* Does an effect need a fluid, and does each fluid property have one source only? */
static int decide_fluid(struct dem *d)
{
    const struct dem_effect *has_own = NULL;
    double viscosity = 0.0;

    d->fluid_user = dem_interaction_table_fluid_user(&d->state.interaction_table);
    d->with_fluid = d->fluid_user != NULL;
    for (int k = 0; k < d->state.interaction_table.chosen; k++)
    {
        const struct dem_effect *const effect = d->state.interaction_table.effect[k];
        const double own =
            dem_interaction_table_own_viscosity(&d->state.interaction_table, effect);

        viscosity = own > 0.0 ? own : viscosity;
        has_own = own > 0.0 ? effect : has_own;
    }
    d->pressure_gradient = dem_interaction_table_has_pressure_gradient(&d->state.interaction_table);
    DEM_REQUIRE(
        !(has_own && (d->with_fluid || d->scene.fluid.given)), DEM_ERROR_INPUT,
        "effects/%s gives viscosity %g Pa s, but the fluid of the run has one too; remove viscosity from %s",
        has_own->name, viscosity, has_own->name);
    return refuse_added_mass_twice(&d->state.interaction_table);
}

/* Initial outer and inner skin [m]: thin, as suits a bed at rest; fast particles make them
   thicker at once. *max is the upper bound of both: a diameter, and in a periodic domain less
   than where a particle would find its own image. */
static void choose_skins(const struct dem_state *p, double radius, double skin[2], double *max)
{
    double min_radius = radius;

    for (int m = 0; m < DEM_MATERIALS; m++)
    {
        min_radius = p->interaction_table.min_radius[m] > 0.0
                       ? fmin(min_radius, p->interaction_table.min_radius[m])
                       : min_radius;
    }
    *max = 2.0*radius;
    for (int k = 0; k < 3; k++)
    {
        *max = p->domain.periodic[k]
                 ? fmin(*max,
                        0.99*(p->domain.length[k] - 2.0*radius - p->interaction_table.reach))
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

static int prepare_physics(struct dem *d)
{
    struct dem_state *const p = &d->state;

    if (d->load_path[0])
    {
        DEM_TRY(dem_api_find_radii(p));
        DEM_TRY(dem_api_agree(d, dem_api_add_radii(d)));
        DEM_TRY(dem_api_finish_physics(d));
    }
    DEM_TRY(dem_api_insert_new_groups(d));
    const double radius = dem_api_max_radius(d);
    double skin[2] = {2.0*radius*d->scene.outer_skin, 2.0*radius*d->scene.inner_skin};
    double max_skin = 2.0*radius;

    if (d->scene.tuned_skins)
    {
        choose_skins(p, radius, skin, &max_skin);
    }

    DEM_TRY(dem_wall_store_distribute(&p->wall_store, &p->walls));
    DEM_TRY(dem_contacts_init(&p->contacts, &p->interaction_table));
    p->contacts.forces.all_rows |= d->virial || d->scene.averages > 0;
    dem_pairs_init(&p->pairs, &p->domain, skin, p->interaction_table.reach, radius);
    if (d->scene.tuned_skins && radius > 0.0)
    {
        dem_pairs_tune(&p->pairs, max_skin);
        resume_skins(&p->pairs.skins, &d->snapshot_skins);
    }
    return dem_wall_search_prepare(&p->pairs.wall_search, &p->walls, radius > 0.0 ? radius : 1.0);
}

/* A larger overlap at the start is an error in the input, not a contact. `flags`: of particles with one
   of them only; 0: of all. */
static int refuse_overlap(struct dem_state *p, double limit, unsigned flags)
{
    struct dem_overlap pair, wall;

    dem_totals_max_overlap(p, flags, &pair, &wall);
    DEM_REQUIRE(wall.fraction <= limit || wall.fraction <= pair.fraction,
                DEM_ERROR_INPUT,
                "particle %lld at (%g %g %g) m overlaps wall %s by %.3g of a diameter at the "
                "start, the limit is %g; move it, or raise time/maxStartOverlap",
                (long long)wall.id, wall.x[0], wall.x[1], wall.x[2],
                p->walls.wall[wall.partner].name, wall.fraction, limit);
    DEM_REQUIRE(pair.fraction <= limit, DEM_ERROR_INPUT,
                "particles %lld and %lld at (%g %g %g) m overlap by %.3g of a diameter at the "
                "start, the limit is %g; move them apart, or raise time/maxStartOverlap",
                (long long)pair.id, (long long)pair.partner, pair.x[0], pair.x[1], pair.x[2],
                pair.fraction, limit);
    return DEM_OK;
}

/* A snapshot that was made in other walls may overlap the walls of this run. A soft bed that
   has settled in the same walls overlaps them too, but not more than its particles overlap each
   other; in a state in motion it may be twice as much. */
static int refuse_other_walls(struct dem *d)
{
    const struct dem_overlap *const wall = &d->start_wall, *const pair = &d->start_pair;
    const double limit = fmax(d->scene.max_start_overlap, 2.0*pair->fraction);

    DEM_REQUIRE(wall->fraction <= limit, DEM_ERROR_INPUT,
                "%s: particle %lld at (%g %g %g) m overlaps wall %s by %.3g of a diameter at the "
                "start, the limit is %.3g; the snapshot was made in other walls: settle the "
                "particles in the walls of this run (in an OpenFOAM case: demPimpleFoam -settle) "
                "and start from that snapshot",
                d->load_path, (long long)wall->id, wall->x[0], wall->x[1], wall->x[2],
                d->state.walls.wall[wall->partner].name, wall->fraction, limit);
    return DEM_OK;
}

static int read_contacts(struct dem *d)
{
    struct dem_state *const p = &d->state;
    struct dem_snapshot_facets facets;
    int status = dem_api_agree(d, dem_api_map_facets(d, &facets));

    status = status ? status
                    : dem_snapshot_read_contacts(d->load_path, &p->decomposition,
                                                 &p->interaction_table, &p->particles, &facets,
                                                 &p->contacts);
    dem_memory_free(facets.number);
    return status;
}

/* Send particles to their owners. Without a snapshot also build the first lists, refuse
   overlaps, and compute the forces with which the first half kick begins; a snapshot holds them. */
static int distribute(struct dem *d)
{
    struct dem_state *const p = &d->state;

    DEM_TRY(
        dem_collect_agree(&p->decomposition, dem_domain_project_all(&p->domain, &p->particles)));
    DEM_TRY(dem_decomposition_balance(&p->decomposition, &p->particles, NULL));
    DEM_TRY(dem_collect_agree(&p->decomposition, dem_halo_migrate(&p->halo, DEM_OK, &p->particles,
                                                                  &p->contacts)));
    p->stale = 2;
    dem_walls_move(&p->walls, p->time, 0.0);
    if (d->load_path[0])
    {
        return read_contacts(d);
    }
    DEM_TRY(dem_neighbor_rebuild(p));
    p->stale = 1;
    DEM_TRY(dem_collect_agree(&p->decomposition, refuse_overlap(p, d->scene.max_start_overlap, 0)));
    DEM_TRY(dem_bond_pairs_mark(p, d->scene.bond_ids, d->scene.bond_id_count));
    DEM_TRY(dem_sweep_contacts_and_sum(p, 0.0, (const double[2]){-INFINITY, p->time}));
    dem_sum_bond_energies(&p->particles, &p->contacts);
    p->limits.overlap = 0.0;
    return DEM_OK;
}

static int begin_energy(struct dem *d)
{
    struct dem_state *const p = &d->state;
    int status =
        dem_sweep_contacts_and_bodies(p, 0.0, (const double[2]){p->time, p->time}, NULL);

    status = dem_collect_agree(&p->decomposition, status);
    if (!status)
    {
        dem_energy_balance_begin(p);
    }
    return status;
}

static int measure_overlap(struct dem *d)
{
    return dem_totals_max_overlap_over_ranks(&d->state, &d->start_pair, &d->start_wall);
}

/* Call `look` with the lists built from the state of a snapshot, on a backup; then everything is
   put back, so that the run goes on with the same bits. */
static int with_lists(struct dem *d, int (*look)(struct dem *))
{
    struct dem_state *const p = &d->state;
    const int64_t rebuilds = p->rebuilds, prunes = p->prunes;
    const size_t losses = p->lost_particles->n, broke = p->bonds->n;
    struct dem_backup backup = {.valid = 0};

    dem_flows_backup(p->flows);
    int status = dem_api_agree(d, dem_backup_save(&backup, &p->particles, &p->contacts,
                                                  p->pairs.wall_facet));

    status = status ? status : dem_neighbor_rebuild(p);
    status = status ? status : look(d);
    status = dem_collect_agree(&p->decomposition, status);
    if (status)
    {
        dem_backup_free(&backup);
        return status;
    }
    status = dem_backup_restore(&backup, &p->particles, &p->contacts);
    dem_backup_free(&backup);
    p->stale = 2;
    p->limits.overlap = 0.0;
    dem_flows_restore(p->flows);
    p->lost_particles->n = losses;
    p->bonds->n = broke;
    p->rebuilds = rebuilds;
    p->prunes = prunes;
    return status;
}

/* The energy that contacts hold at the start. Without a snapshot the first sweep has measured
   it. With one, the contacts are swept once on a backup. */
static int begin_energy_balance(struct dem *d)
{
    if (!d->load_path[0])
    {
        dem_flows_backup(d->state.flows);
        dem_energy_balance_begin(&d->state);
        return DEM_OK;
    }
    return with_lists(d, begin_energy);
}

static int refuse_new_overlap(struct dem *d)
{
    return refuse_overlap(&d->state, d->scene.max_start_overlap, DEM_PARTICLE_NEW);
}

/* Particles that are inserted at a restart. */
static int check_inserted(struct dem *d)
{
    struct dem_particles *const p = &d->state.particles;

    if (!d->inserts || !d->load_path[0])
    {
        return DEM_OK;
    }
    DEM_TRY(with_lists(d, refuse_new_overlap));
    for (size_t i = 0; i < p->n; i++)
    {
        p->record[i].flags &= (uint16_t)~DEM_PARTICLE_NEW;
    }
    return DEM_OK;
}

/* Particles of the scene's entry `start`, or of dem_start. */
static int check_start(struct dem *d)
{
    if (!d->start_checked || d->state.walls.walls == 0)
    {
        return DEM_OK;
    }
    DEM_TRY(with_lists(d, measure_overlap));
    return refuse_other_walls(d);
}

static void append_word(char *list, size_t capacity, const char *word)
{
    const size_t length = strlen(list);

    snprintf(list + length, capacity - length, "%s%s", length > 0 ? " " : "", word);
}

static void list_effects(struct dem *d)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;

    memcpy(d->heading, "effects: ", DEM_HEADING + 1);
    d->fluid_effects[0] = '\0';
    for (int k = 0; k < r->chosen; k++)
    {
        append_word(d->heading + DEM_HEADING, sizeof d->heading - DEM_HEADING, r->effect[k]->name);
        if (r->effect[k]->stage == DEM_STAGE_FLUID)
        {
            append_word(d->fluid_effects, sizeof d->fluid_effects, r->effect[k]->name);
        }
    }
}

/* Mark the scalars of dem_scalar_exchange_enable. */
static int enable_exchanges(struct dem *d)
{
    struct dem_interaction_table *const r = &d->state.interaction_table;

    for (int e = 0; e < d->exchanges; e++)
    {
        const int k = dem_interaction_table_find_scalar(r, d->exchanged[e]);

        DEM_REQUIRE(k >= 0 && r->scalar[k]->exchange, DEM_ERROR_INPUT,
                    "the program exchanges %s, but no effect of the scene has this scalar; add one",
                    d->exchanged[e]);
        r->exchanged[k] = 1;
    }
    return DEM_OK;
}

static int read_scene(struct dem *d)
{
    struct dem_state *const p = &d->state;

    DEM_TRY(dem_scene_read_materials(d->dict, &p->interaction_table));
    dem_api_begin_walls(d);
    DEM_TRY(dem_api_add_mesh_walls(d));
    DEM_TRY(dem_scene_read(&d->scene, d->dict, &p->interaction_table, &p->walls, &p->domain));
    DEM_TRY(dem_scene_read_forces(d->dict, &p->interaction_table, &p->applied_forces));
    DEM_TRY(dem_api_assign_patches(d));
    if (d->scene.snapshot && !d->load_path[0])
    {
        DEM_TRY(dem_start(d, d->scene.snapshot));
        d->scene_start = 1;
    }
    p->limits.limit = d->scene.max_overlap;
    p->limits.max_speed = d->scene.max_speed;
    p->interaction_table.fluid_density =
        d->scene.fluid.given ? d->scene.fluid.density : d->fluid_density;
    DEM_TRY(decide_fluid(d));
    DEM_TRY(enable_exchanges(d));
    list_effects(d);
    return dem_api_check_scene(d);
}

/* Sums of the averages when the snapshot was written. The snapshot of the scene's entry `start`
   gives particles only. */
static int resume_averages(struct dem *d)
{
    void *bytes;
    size_t size;

    if (!d->load_path[0] || d->scene_start || d->state.averages->grids == 0
        || d->state.decomposition.rank > 0)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_snapshot_read_caller_data(d->load_path, &bytes, &size));
    const int status = dem_grid_averages_restore(d->state.averages, d->load_path, bytes, size);

    dem_memory_free(bytes);
    return status;
}

int dem_api_read_scene(struct dem *d)
{
    int status = dem_api_agree(d, read_scene(d));    /* the first rank alone reads surfaces */

    if (!status && !d->load_path[0])
    {
        status = dem_api_agree(d, dem_api_finish_physics(d));
    }
    d->checked = status ? -1 : 1;
    return status;
}

/* Asked for, or needed by an effect that makes heat of what contacts dissipate. */
static int has_energy_balance(const struct dem *d)
{
    return d->energy || d->state.interaction_table.needs & DEM_NEEDS_DISSIPATION;
}

/* Ranks read different parts of a snapshot, so one may fail alone. */
int dem_api_setup(struct dem *d)
{
    if (!d->checked)
    {
        DEM_TRY(dem_api_read_scene(d));
    }
    DEM_TRY(dem_api_agree(d, dem_api_create_particles(d)));
    dem_orientation_begin(&d->state.particles);
    DEM_TRY(dem_api_agree(d, prepare_physics(d)));
    DEM_TRY(dem_api_agree(d, dem_api_position_mesh_walls(d)));
    if (d->scene.fluid.given || !d->load_path[0])
    {
        dem_api_init_fluid(d);
    }
    if (has_energy_balance(d))
    {
        DEM_TRY(dem_api_agree(d, dem_energy_balance_open(d->state.energy_balance,
                                                         &d->state.interaction_table)));
    }
    DEM_TRY(dem_api_agree(d, dem_api_begin_flows(d)));
    DEM_TRY(dem_api_agree(d, distribute(d)));
    DEM_TRY(dem_api_agree(d, check_start(d)));
    DEM_TRY(dem_api_agree(d, check_inserted(d)));
    d->driven = dem_totals_any_driven(&d->state);
    if (has_energy_balance(d))
    {
        DEM_TRY(dem_api_agree(d, begin_energy_balance(d)));
    }
    /* drag laws of the interrupted window take the fluid columns as loaded */
    if (d->state.window.half_step_ahead)
    {
        dem_bodies_window_constants(&d->state.particles, &d->state.interaction_table.bodies);
    }
    for (int k = 0; k < d->scene.averages; k++)
    {
        d->scene.average[k].comment = d->heading;
    }
    DEM_TRY(dem_api_agree(d, dem_grid_averages_init(d->state.averages, d->scene.average,
                                                    d->scene.averages,
                                                    &d->state.interaction_table, d->state.time,
                                                    d->state.decomposition.rank == 0)));
    DEM_TRY(dem_api_agree(d, resume_averages(d)));
    dem_timers_begin(d->state.timers, d->state.rebuilds, d->state.prunes, d->state.agreements);
    d->state.halo.refresh_traffic = d->state.halo.in.sent = (struct dem_traffic){0, 0};
    d->is_set_up = 1;
    return DEM_OK;
}
