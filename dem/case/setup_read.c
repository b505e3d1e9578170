/*
 * setup_read.c -- read a scene and check all that needs no particles (setup_check.c): first step of
 * the set-up.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/dem_case.h"
#include "core/error.h"
#include <fenv.h>
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

/* Mark the scalars of dem_case_exchange_scalar. */
static int enable_exchanges(struct dem_case *c)
{
    struct dem_interaction_table *const r = &c->d->state.interaction_table;

    for (int e = 0; e < c->exchanges; e++)
    {
        const int k = dem_interaction_table_find_scalar(r, c->exchanged[e]);

        DEM_REQUIRE(k >= 0 && r->scalar[k]->exchange, DEM_ERROR_INPUT,
                    "the program exchanges %s, but no effect of the scene has this scalar; add one",
                    c->exchanged[e]);
        r->exchanged[k] = 1;
    }
    return DEM_OK;
}

static int read_scene(struct dem_case *c)
{
    struct dem *const d = c->d;
    struct dem_state *const state = &d->state;

    DEM_TRY(dem_scene_read_materials(d->dict, &state->interaction_table));
    dem_sim_begin_walls(d);
    DEM_TRY(dem_sim_add_mesh_walls(d));
    DEM_TRY(dem_sim_agree(d, dem_scene_read(&d->scene, d->dict, &state->interaction_table,
                                            &state->walls, &state->domain)));
    DEM_TRY(dem_sim_begin_bodies(d));
    state->cell = d->scene.cell;
    DEM_TRY(dem_scene_read_forces(d->dict, &state->interaction_table, &state->applied_forces));
    DEM_TRY(dem_sim_assign_patches(d));
    if (d->scene.snapshot && !c->load_path[0])
    {
        DEM_TRY(dem_case_start_from(c, d->scene.snapshot));
        c->scene_start = 1;
    }
    state->limits.overlap_limit = d->scene.max_overlap;
    state->limits.speed_limit = d->scene.max_speed;
    state->interaction_table.fluid_density =
        d->scene.fluid.given ? d->scene.fluid.density : c->fluid_density;
    DEM_TRY(decide_fluid(d));
    DEM_TRY(enable_exchanges(c));
    list_effects(d);
    DEM_TRY(dem_stages_check(d));
    DEM_TRY(dem_cell_refuse(d));
    return dem_sim_check_scene(c);
}

int dem_sim_read_scene(struct dem_case *c)
{
    struct dem *const d = c->d;
    int status = dem_sim_agree(d, read_scene(c));    /* the first rank alone reads surfaces */

    if (!status && !c->load_path[0])
    {
        status = dem_sim_agree(d, dem_sim_finish_physics(d));
    }
    c->checked = status ? -1 : 1;
    return status;
}

int dem_case_check(struct dem_case *c)
{
    fenv_t caller;

    DEM_REQUIRE(!c->checked, DEM_ERROR_STATE, "dem_case_check has been called already%s",
                c->checked < 0 ? ", and has failed; call dem_case_free and start again" : "");
    DEM_REQUIRE(c->d->dict, DEM_ERROR_STATE, "dem_case_check comes after the scene has been read");
    feholdexcept(&caller);
    const int status = dem_sim_read_scene(c);

    fesetenv(&caller);
    return status;
}

const struct dem *dem_case_checked(const struct dem_case *c)
{
    return c->checked > 0 ? c->d : NULL;
}
