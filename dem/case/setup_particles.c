/*
 * setup_particles.c -- the initial particles: inserted by the scene, added by the program, or read
 * from a snapshot; their columns.
 *
 * Each rank creates a part of them, wherever they lie; setup.c sends them to the ranks that own
 * their positions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/dem_case.h"
#include "case/restart.h"
#include "core/error.h"
#include "core/memory.h"
#include "records/snapshot.h"
#include "laws/fluid/particle_exchange.h"
#include "particles/scalars.h"
#include "particles/uniform_fluid.h"
#include "sources/residence.h"
#include "records/totals.h"
#include <math.h>
#include <string.h>

/* The k-th particle of dem_case_add_particles, with the density of its material. */
static int complete(const struct dem_case *c, size_t k, struct dem_particle *whole)
{
    const struct dem *const d = c->d;
    const struct dem_particle *const p = &c->initial.particle[k];
    int material;

    DEM_TRY(dem_interaction_table_find_material(&d->state.interaction_table, c->initial_material[k],
                                                "dem_case_add_particles", &material));
    *whole = dem_particle_sphere(p->id, p->x, 2.0*p->radius,
                                 d->state.interaction_table.material[material].density, material);
    memcpy(whole->v, p->v, sizeof p->v);
    memcpy(whole->w, p->w, sizeof p->w);
    if (p->flags & DEM_PARTICLE_FROZEN)
    {
        whole->flags = DEM_PARTICLE_FROZEN;
        whole->inverse_mass = whole->inverse_inertia = 0.0;
    }
    return DEM_OK;
}

/* Every rank has the whole list and adds every ranks-th particle of it. `id` gets the ids of
   all. */
static int add_every_nth(struct dem_case *c, int64_t *id)
{
    struct dem *const d = c->d;
    struct dem_initial_particles *const all = &d->scene.initial;
    int64_t next = all->next_id;

    for (size_t k = 0; k < c->initial.n; k++)
    {
        struct dem_particle whole;

        DEM_TRY(complete(c, k, &whole));
        whole.id = id[k] = whole.id < 0 ? next : whole.id;
        DEM_REQUIRE(whole.id < INT64_MAX, DEM_ERROR_INPUT,
                    "dem_case_add_particles: id %lld leaves no next one; give a smaller number",
                    (long long)whole.id);
        next = id[k] >= next ? id[k] + 1 : next;
        dem_initial_particles_count(all, 1, 2.0*whole.radius, dem_particle_volume(&whole), whole.mass,
                                    whole.material);
        if (k%(size_t)d->state.decomposition.ranks == (size_t)d->state.decomposition.rank)
        {
            DEM_TRY(dem_initial_particles_add(all, whole, "dem_case_add_particles"));
        }
    }
    return DEM_OK;
}

/* Particles of dem_case_add_particles join those that the scene inserts. */
int dem_sim_join_initial(struct dem_case *c)
{
    struct dem *const d = c->d;
    int64_t *id;

    if (c->initial.n == 0)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_initial_particles_begin_group(&d->scene.initial, "dem_case_add_particles"));
    DEM_TRY(DEM_NEW(id, c->initial.n));
    int status = add_every_nth(c, id);

    status = status ? status : dem_insert_refuse_duplicates(&d->scene.insertion, c->initial.n, id);
    dem_memory_free(id);
    return status;
}

/* Append this rank's part to the particle arrays. */
int dem_sim_store_initial(struct dem *d, size_t from)
{
    const struct dem_initial_particles *const c = &d->scene.initial;
    struct dem_particles *const p = &d->state.particles;

    DEM_TRY(dem_particles_grow(p, p->n + c->n - from + 1));
    for (size_t k = from; k < c->n; k++)
    {
        DEM_REQUIRE(dem_domain_contains(&d->state.domain, c->particle[k].x), DEM_ERROR_INPUT,
                    "particle %lld at (%g %g %g) m is outside the domain; move it, or enlarge the "
                    "domain",
                    (long long)c->particle[k].id, c->particle[k].x[0], c->particle[k].x[1],
                    c->particle[k].x[2]);
        DEM_TRY(dem_particles_add(p, &c->particle[k]));
        if (c->particle[k].body)
        {
            *dem_clump_of(p, p->n - 1) = c->clump[k];
        }
        for (int m = 0; m < c->scalars; m++)
        {
            dem_scalar_values(p, m)[p->n - 1] = c->scalar[k*(size_t)c->scalars + (size_t)m];
        }
    }
    return DEM_OK;
}

/* A uniform fluid fills the columns once; with a coupled one every particle is marked as not yet
   located in the mesh. */
void dem_sim_init_fluid(struct dem *d)
{
    struct dem_particles *const p = &d->state.particles;
    const double mean =
        dem_column(p, DEM_COLUMN_MEAN_DIAMETER) ? dem_totals_sauter_diameter(&d->state) : 0.0;

    for (size_t i = 0; d->with_fluid && i < p->n; i++)
    {
        dem_uniform_fluid_fill(p, i, &d->scene.fluid, mean);
    }
}

/* 1 when an effect sums energy of bonds or films. The interaction table is not frozen yet when
   particles are created. */
static int sums_bond_energy(const struct dem_interaction_table *r)
{
    int sums = 0;

    for (int k = 0; k < r->chosen; k++)
    {
        sums |= dem_effect_acts_past_touching(r->effect[k]);
    }
    return sums;
}

/* 1 when the particles displace the fluid and some of them are light (dem_case_fluid_displaced). */
static int under_relaxes(const struct dem_case *c)
{
    const struct dem *const d = c->d;
    const struct dem_interaction_table *const r = &d->state.interaction_table;
    double lightest = INFINITY;

    for (int m = 0; m < r->materials; m++)
    {
        lightest = fmin(lightest, r->material[m].density);
    }
    return d->with_fluid && d->pressure_gradient
        && lightest < DEM_EXCHANGE_LIGHT*c->displaced_density;
}

/* The groups of columns that an effect reads or writes. A uniform fluid that no body effect
   reads needs none: contact laws read scalars of it. A coupled program always finds the fluid's
   columns. */
static unsigned column_groups(const struct dem_case *c)
{
    const struct dem *const d = c->d;
    static const struct
    {
        unsigned needs, group;
    } required[] = {
        {DEM_NEEDS_ACCELERATION, DEM_GROUP_ACCELERATION},
        {DEM_NEEDS_VORTICITY, DEM_GROUP_VORTICITY},
        {DEM_NEEDS_STRESS, DEM_GROUP_STRESS},
        {DEM_NEEDS_MEAN_DIAMETER, DEM_GROUP_MEAN_DIAMETER},
        {DEM_NEEDS_TURBULENCE, DEM_GROUP_TURBULENCE},
        {DEM_NEEDS_INTERFACE, DEM_GROUP_INTERFACE},
    };
    const struct dem_interaction_table *const r = &d->state.interaction_table;
    const unsigned needs = dem_interaction_table_needs(r);
    const int acts = needs & DEM_NEEDS_FLUID || !d->scene.fluid.given;
    unsigned groups = (d->with_fluid && acts ? DEM_GROUP_FLUID : 0)
                    | (sums_bond_energy(r) ? DEM_GROUP_PAIR_ENERGY : 0)
                    | (c->orientation ? DEM_GROUP_ORIENTATION : 0)
                    | (under_relaxes(c) ? DEM_GROUP_UNDER_RELAXATION : 0)
                    | (c->own_wake ? DEM_GROUP_OWN_WAKE : 0)
                    | (d->scene.shapes.n > 0 ? DEM_GROUP_CLUMP : 0)
                    | (dem_streams_have_regions(&d->scene.streams) ? DEM_GROUP_OUTLETS : 0)
                    | (dem_streams_ask_residence(&d->scene.streams) ? DEM_GROUP_BIRTH : 0);

    for (size_t k = 0; k < sizeof required/sizeof required[0]; k++)
    {
        groups |= needs & required[k].needs ? required[k].group : 0;
    }
    for (int k = 0; k < r->chosen; k++)
    {
        const struct dem_effect *const e = r->effect[k];

        groups |= (e->drag && e->prepare_bodies ? DEM_GROUP_VOIDAGE_FACTOR : 0)
                | (e->has_reaction ? DEM_GROUP_REACTION : 0)
                | (e->has_added_mass ? DEM_GROUP_ADDED_MASS : 0)
                | (e->has_rotational_drag ? DEM_GROUP_ROTATIONAL_DRAG : 0);
    }
    return groups;
}

/* A snapshot may come from a run with added mass; each window adds the mass of this run. */
static void remove_added_mass(struct dem_particles *p)
{
    for (size_t i = 0; i < p->n; i++)
    {
        struct dem_particle *const r = &p->record[i];
        const struct dem_clump *const b = dem_clump_of(p, i);

        r->inverse_mass = r->inverse_mass > 0.0 ? 1.0/(b ? b->mass : r->mass) : 0.0;
    }
}

/* 1 when the scene has the entry `start` and the run begins by it: from its snapshot, or from one that
   dem_case_start_from names. */
static int has_start(const struct dem_case *c)
{
    return c->d->scene.snapshot && c->new_run;
}

/* Particles of a snapshot keep the scalars that it has. The scene's entry `start` may give others;
   scalars that neither has get the default of their row. */
static int complete_scalars(struct dem_case *c)
{
    struct dem *const d = c->d;
    const struct dem_interaction_table *const r = &d->state.interaction_table;
    struct dem_particles *const p = &d->state.particles;

    for (int k = 0; k < r->scalars; k++)
    {
        const struct dem_scalar_entry fallback = {.min = r->scalar[k]->default_value,
                                                  .max = r->scalar[k]->default_value};
        const struct dem_scalar_entry *const start = has_start(c) ? &d->scene.start_scalar[k]
                                                                  : &fallback;
        const int in_file = (c->snapshot_flows.scalars >> k & 1) != 0;

        DEM_REQUIRE(in_file || start->given || !isnan(r->scalar[k]->default_value), DEM_ERROR_INPUT,
                    "%s has no %s, which the effects need; add start { snapshot \"FILE\"; %s "
                    "NUMBER; }", c->load_path, r->scalar[k]->name, r->scalar[k]->name);
        for (size_t i = 0; (start->given || !in_file) && i < p->n; i++)
        {
            const struct dem_particle *const q = &p->record[i];

            dem_scalar_values(p, k)[i] =
                dem_scalar_draw(start, k, 1, (uint64_t)(q->body ? q->body - 1 : q->id));
        }
    }
    return dem_scalars_check(p, r, " in the snapshot");
}

/* The scene's entry start/frozen. */
static void freeze_or_free(struct dem_case *c)
{
    struct dem *const d = c->d;

    for (size_t i = 0; has_start(c) && d->scene.start_frozen >= 0 && i < d->state.particles.n; i++)
    {
        struct dem_particle *const r = &d->state.particles.record[i];
        const int frozen = d->scene.start_frozen;

        r->flags = (uint16_t)((r->flags & ~(DEM_PARTICLE_FROZEN | DEM_PARTICLE_DRIVEN)) |
                              (frozen ? DEM_PARTICLE_FROZEN : 0));
        r->inverse_mass = frozen ? 0.0 : 1.0/r->mass;
        r->inverse_inertia = frozen ? 0.0 : 1.0/(0.4*r->mass*r->radius*r->radius);
        memset(r->v, 0, sizeof r->v);
        memset(r->w, 0, sizeof r->w);
    }
}

/* Resume the window that was interrupted when the snapshot was written. */
static void resume_window(struct dem_state *state, const struct dem_snapshot_window *w)
{
    state->window.half_step_ahead = w->ahead > 0;
    state->window.steps = w->ahead;
    state->window.steps_before = state->steps - w->done;
    state->window.start = w->opened;
    state->dt = w->dt;
    state->window.length = w->dt*(double)w->ahead;
}

/* A scene that starts from a snapshot (entry `start`) counts its own streams from 0; the ids
   go on behind the file's. */
int dem_sim_begin_flows(struct dem_case *c)
{
    struct dem *const d = c->d;

    d->state.flows->fluid = &d->scene.fluid;
    d->state.flows->asked = d->flow_on_request;
    c->snapshot_flows.flows = c->scene_start ? 0 : c->snapshot_flows.flows;
    DEM_TRY(dem_flows_begin(&d->state, &d->scene.streams,
                            c->load_path[0] ? &c->snapshot_flows : NULL));
    return dem_residence_begin(&d->state, d->before.text);
}

int dem_sim_create_particles(struct dem_case *c)
{
    struct dem *const d = c->d;
    struct dem_state *const state = &d->state;
    struct dem_snapshot s;

    d->program_particles = c->initial.n > 0;
    dem_particles_init(&state->particles, column_groups(c));
    DEM_TRY(dem_scalars_add_columns(&state->particles, &state->interaction_table));
    DEM_TRY(dem_sim_agree(d, dem_particles_grow(&state->particles, 1)));
    if (c->load_path[0])
    {
        /* a rank may have the only particle that is refused */
        DEM_TRY(dem_sim_agree(d, dem_snapshot_read_particles(c->load_path, &s, &state->decomposition,
                                                             &state->interaction_table,
                                                             &state->particles)));
        state->time = s.time;
        state->steps = s.steps;
        resume_window(state, &s.window);
        remove_added_mass(&state->particles);
        memcpy(&c->snapshot_skins, s.skin_tuning, sizeof c->snapshot_skins);
        c->snapshot_flows = s;
        freeze_or_free(c);
        DEM_TRY(dem_sim_agree(d, complete_scalars(c)));
        return dem_sim_compare_scene(c);
    }
    state->time = c->start_time;
    dem_walls_move(&state->walls, state->time, 0.0);
    DEM_TRY(dem_stages_start(d, 0));
    DEM_TRY(dem_insert_place(&d->scene.initial, &d->scene.insertion, &state->interaction_table,
                             &state->walls, &state->decomposition));
    DEM_TRY(dem_sim_join_initial(c));
    dem_insert_free(&d->scene.insertion);
    DEM_TRY(dem_sim_store_initial(d, 0));
    dem_initial_particles_release(&d->scene.initial);
    dem_initial_particles_release(&c->initial);
    return DEM_OK;
}
