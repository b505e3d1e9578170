/*
 * restart_insert.c -- insert groups that the snapshot of a restart does not know.
 *
 * They are placed as at a start, with the particles of the snapshot as an earlier group, and
 * take the next free ids. Contacts of other particles and forces stay as loaded: a new particle
 * touches nothing, or is refused with time/maxStartOverlap.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/restart.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "sources/flows.h"
#include "ranks/collect.h"
#include <stdlib.h>
#include <string.h>

/* The particles of the snapshot become the first ones of the list, without their scalars. */
static int list_present(struct dem *d)
{
    struct dem_initial_particles *const c = &d->scene.initial;
    const struct dem_particles *const p = &d->state.particles;

    dem_initial_particles_have_scalars(c, &d->state.interaction_table);
    DEM_TRY(DEM_GROW(c->particle, c->capacity, p->n + 1));
    DEM_TRY(DEM_GROW(c->scalar, c->scalar_capacity, (p->n + 1)*(size_t)(c->scalars + 1)));
    memcpy(c->particle, p->record, p->n*sizeof *c->particle);
    c->n = p->n;
    return DEM_OK;
}

static int compare_ids(const void *a, const void *b)
{
    const int64_t p = *(const int64_t *)a, q = *(const int64_t *)b;

    return (p > q) - (p < q);
}

/* An id that the scene or the program gives must not be one of the snapshot. */
static int refuse_present_ids(const struct dem_case *of, size_t present)
{
    const struct dem *const d = of->d;
    const struct dem_initial_particles *const c = &d->scene.initial;
    int64_t *id, duplicate = -1;

    DEM_TRY(DEM_NEW(id, c->n - present + 1));
    for (size_t k = present; k < c->n; k++)
    {
        id[k - present] = c->particle[k].id;
    }
    const struct dem_collect_items own = {"new particles", id, c->n - present, sizeof *id};
    void *all;
    size_t n;
    int status = dem_collect_gather(&d->state.decomposition, DEM_OK, &own, &all, &n);

    dem_memory_free(id);
    DEM_TRY(status);
    dem_sort_by(all, n, sizeof *id, compare_ids);
    for (size_t k = 0; k < present && n > 0; k++)
    {
        duplicate = bsearch(&c->particle[k].id, all, n, sizeof *id, compare_ids)
                      ? c->particle[k].id
                      : duplicate;
    }
    dem_memory_free(all);
    DEM_REQUIRE(duplicate < 0, DEM_ERROR_INPUT, "a new particle has id %lld, which a particle of %s "
                "has already; give it another id, or none: then the next free one is taken",
                (long long)duplicate, of->load_path);
    return DEM_OK;
}

/* Columns of the new particles; in a window that is not complete, those that its begin has set, and
   the velocity half a step ahead like all others. */
static void begin_columns(struct dem *d, size_t from)
{
    struct dem_state *const state = &d->state;
    double g[3];

    dem_interaction_table_gravity(&state->interaction_table, g);
    for (size_t i = from; i < state->particles.n; i++)
    {
        struct dem_particle *const q = &state->particles.record[i];

        q->flags |= DEM_PARTICLE_NEW;
        dem_flows_begin_columns(state, i, &d->scene.fluid);
        for (int k = 0; k < 3 && state->window.half_step_ahead && q->inverse_mass > 0.0; k++)
        {
            q->v[k] += 0.5*state->dt*g[k];
            if (q->body)
            {
                dem_clump_of(&state->particles, i)->v[k] += 0.5*state->dt*g[k];
            }
        }
    }
}

static int tell(struct dem_case *of)
{
    struct dem *const d = of->d;
    const struct dem_initial_particles *const c = &d->scene.initial;

    for (size_t k = 0; k < c->groups; k++)
    {
        const int of_program = of->initial.n > 0 && k + 1 == c->groups;

        DEM_TRY(dem_sim_note(d, "restart: %s%s is new: its %lld particles are inserted now",
                             of_program ? "" : "insert/", c->group[k].name,
                             (long long)c->group[k].n));
    }
    return DEM_OK;
}

static int insert(struct dem_case *of)
{
    struct dem *const d = of->d;
    struct dem_state *const state = &d->state;
    struct dem_initial_particles *const c = &d->scene.initial;
    const size_t present = state->particles.n;

    DEM_TRY(dem_sim_agree(d, list_present(d)));
    c->next_id = d->next_id;
    dem_walls_move(&state->walls, state->time, 0.0);
    DEM_TRY(dem_insert_place(c, &d->scene.insertion, &state->interaction_table, &state->walls,
                             &state->decomposition));
    DEM_TRY(dem_sim_agree(d, dem_sim_join_initial(of)));
    DEM_TRY(dem_sim_agree(d, refuse_present_ids(of, present)));
    DEM_TRY(dem_sim_agree(d, dem_sim_store_initial(d, present)));
    begin_columns(d, present);
    return dem_sim_agree(d, tell(of));
}

int dem_sim_insert_new_groups(struct dem_case *c)
{
    struct dem *const d = c->d;
    const int64_t free_id = dem_flows_first_free_id(&d->state);

    d->next_id = d->before.tail.next_id > free_id ? d->before.tail.next_id : free_id;
    c->inserts = d->scene.insertion.n > 0 || c->initial.n > 0;
    if (c->inserts)
    {
        DEM_TRY(insert(c));
        const int64_t next = dem_flows_first_free_id(&d->state);

        d->next_id = next > d->next_id ? next : d->next_id;
    }
    if (c->load_path[0])
    {
        dem_insert_free(&d->scene.insertion);
        dem_initial_particles_free(&d->scene.initial);
        dem_initial_particles_release(&c->initial);
    }
    return DEM_OK;
}
