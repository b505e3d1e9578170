/*
 * edit_add.c -- add particles between two advances (run/edit.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/edit.h"
#include "core/error.h"
#include "core/memory.h"
#include "particles/orientation.h"
#include "particles/scalars.h"
#include "sources/flows.h"
#include <fenv.h>
#include <string.h>

/* Time step, lists and constants of the laws follow from the radii of the start. */
int dem_edit_check_radius(const struct dem *d, const char *call, const struct dem_particle *q)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;
    const double min = r->min_radius[q->material], max = r->max_radius[q->material];

    DEM_REQUIRE(q->radius >= min && q->radius <= max, DEM_ERROR_INPUT,
                "%s: particle %lld of material %s has diameter %g m, but time step and lists are "
                "made for diameters from %g to %g m of it; allow others with "
                "dem_case_allow_diameters (Python: sim.allow_diameters)",
                call, (long long)q->id, r->material[q->material].name, 2.0*q->radius, 2.0*min,
                2.0*max);
    return DEM_OK;
}

int dem_edit_place(const struct dem *d, const char *call, struct dem_particle *q)
{
    const int near = dem_domain_project(&d->state.domain, q);
    const double x[3] = {q->x[0], q->x[1], q->x[2]};

    if (near && dem_domain_contains(&d->state.domain, x))
    {
        dem_domain_wrap(&d->state.domain, q);
        q->image = 0;
        return DEM_OK;
    }
    return dem_error(DEM_ERROR_INPUT,
                     "%s: particle %lld at (%g %g %g) m is outside the domain; move it", call,
                     (long long)q->id, x[0], x[1], x[2]);
}

int64_t dem_edit_next_id(const struct dem *d)
{
    return d->next_id > d->state.flows->next_id ? d->next_id : d->state.flows->next_id;
}

static int check_new(struct dem *d, struct dem_edit *e, int64_t k)
{
    const struct dem_new_particle *const given = &e->new[k];
    struct dem_initial_particles *const to = &e->add;
    int material;

    DEM_TRY(dem_interaction_table_find_material(&d->state.interaction_table, given->material,
                                                e->call, &material));
    struct dem_particle q =
        dem_particle_sphere(given->id, given->position, given->diameter,
                            d->state.interaction_table.material[material].density, material);

    memcpy(q.v, given->velocity, sizeof q.v);
    memcpy(q.w, given->spin, sizeof q.w);
    q.flags = given->frozen ? DEM_PARTICLE_FROZEN : 0;
    q.inverse_mass = given->frozen ? 0.0 : q.inverse_mass;
    q.inverse_inertia = given->frozen ? 0.0 : q.inverse_inertia;
    DEM_REQUIRE(q.id < 0 || q.id >= dem_edit_next_id(d), DEM_ERROR_INPUT,
                "%s: id %lld; the run has had ids up to %lld, and none is used twice: give a larger "
                "one, or none", e->call, (long long)q.id, (long long)dem_edit_next_id(d) - 1);
    DEM_TRY(dem_initial_particles_add(to, q, e->call));
    struct dem_particle *const added = &to->particle[to->n - 1];

    DEM_TRY(dem_edit_check_radius(d, e->call, added));
    return dem_edit_place(d, e->call, added);
}

static int check_all_new(struct dem *d, struct dem_edit *e)
{
    e->add.next_id = dem_edit_next_id(d);
    dem_initial_particles_have_scalars(&e->add, &d->state.interaction_table);
    DEM_TRY(DEM_NEW(e->id, e->n + 1));
    for (int64_t k = 0; k < e->n; k++)
    {
        DEM_TRY(check_new(d, e, k));
        e->id[k] = e->add.particle[k].id;
    }
    return dem_edit_list(e, e->id);
}

int dem_edit_add(struct dem *d, const struct dem_edit *e)
{
    struct dem_state *const state = &d->state;

    for (size_t k = 0; k < e->add.n; k++)
    {
        const struct dem_particle *const q = &e->add.particle[k];
        const struct dem_clump *const body = q->body ? &e->add.clump[k] : NULL;

        if (state->decomposition.ranks > 1 &&
            dem_decomposition_owner(&state->decomposition, body ? body->x : q->x) != state->decomposition.rank)
        {
            continue;
        }
        DEM_TRY(dem_particles_add(&state->particles, q));
        if (body)
        {
            *dem_clump_at(&state->particles, state->particles.n - 1) = *body;
        }
        state->particles.record[state->particles.n - 1].flags |= DEM_PARTICLE_NEW;
        for (int m = 0; m < e->add.scalars; m++)
        {
            dem_scalar_values(&state->particles, m)[state->particles.n - 1] = e->add.default_scalar[m];
        }
        dem_flows_begin_columns(state, state->particles.n - 1, &d->scene.fluid);
    }
    dem_orientation_begin(&state->particles);
    return DEM_OK;
}

int dem_add_particles(struct dem *d, int64_t n, const struct dem_new_particle *new, int64_t *id)
{
    struct dem_edit e = {.call = "dem_add_particles", .n = n, .new = new, .change = dem_edit_add, .lists = 1};
    fenv_t caller;
    int status = dem_edit_check_state(d, e.call);

    status = status ? status : dem_sim_require_count(e.call, "particles", n);
    feholdexcept(&caller);
    status = status ? status : check_all_new(d, &e);
    fesetenv(&caller);
    status = dem_edit_make(d, &e, status);
    if (id && n > 0 && !status)
    {
        memcpy(id, e.id, (size_t)n*sizeof *id);
    }
    dem_memory_free(e.id);
    dem_initial_particles_free(&e.add);
    return status;
}
