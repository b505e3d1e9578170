/*
 * edit.c -- check and make an edit of the particles; put the state back after an error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/edit.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "device/device_steps.h"
#include "ranks/collect.h"
#include "records/energy_balance.h"
#include "records/totals.h"
#include "records/wall_statistics.h"
#include "sources/flows.h"
#include "step/step_backup.h"
#include "step/sweep_contacts.h"
#include <fenv.h>
#include <stdlib.h>

/* ---- checks ---------------------------------------------------------------------------------- */

int dem_edit_check_state(const struct dem *d, const char *call)
{
    const struct dem_window *const w = &d->state.window;

    DEM_TRY(dem_sim_require_sound(d, call));
    DEM_REQUIRE(!d->coupled, DEM_ERROR_STATE,
                "%s: the run is coupled with a fluid, which has to know of all particles; use "
                "streams and outlets", call);
    DEM_REQUIRE(!d->state.cell.active, DEM_ERROR_STATE,
                "%s: the periodic cell deforms, and velocities are relative to it; make the edit before "
                "it does", call);
    DEM_REQUIRE(!w->half_step_ahead, DEM_ERROR_STATE,
                "%s: the last advance was stopped, with velocities half a step ahead of positions; before this call "
                "advance by a step, %.9g s, or by the rest of it, %.17g s", call, d->state.dt,
                w->start + w->length - d->state.time);
    return DEM_OK;
}

static int by_id(const void *a, const void *b)
{
    const struct dem_edit_item *const p = a, *const q = b;

    return (p->id > q->id) - (p->id < q->id);
}

const struct dem_edit_item *dem_edit_find(const struct dem_edit *e, int64_t id)
{
    const struct dem_edit_item key = {.id = id};

    return e->n > 0 ? bsearch(&key, e->item, (size_t)e->n, sizeof key, by_id) : NULL;
}

int dem_edit_list(struct dem_edit *e, const int64_t *id)
{
    DEM_TRY(DEM_NEW(e->item, e->n + 1));
    for (int64_t k = 0; k < e->n; k++)
    {
        e->item[k] = (struct dem_edit_item){id[k], k};
    }
    dem_sort_by(e->item, (size_t)e->n, sizeof *e->item, by_id);
    for (int64_t k = 1; k < e->n; k++)
    {
        DEM_REQUIRE(e->item[k].id != e->item[k - 1].id, DEM_ERROR_INPUT,
                    "%s: id %lld stands twice in the list; give each id once", e->call,
                    (long long)e->item[k].id);
    }
    return DEM_OK;
}

/* The sphere stands for its clump, or is one of all of them. */
static int clump_allows(const struct dem_edit *e, const struct dem_particle *q)
{
    return dem_edit_moves(e) ? dem_clump_counts(q) : e->to || !q->body || dem_edit_find(e, q->body - 1);
}

int dem_edit_require_present(struct dem *d, const struct dem_edit *e, int status)
{
    uint8_t *present = NULL;
    int64_t missing = -1, clumped[2] = {-1, -1};

    DEM_TRY(dem_sim_agree(d, status ? status : DEM_NEW(present, e->n + 1)));
    for (size_t i = 0; i < d->state.particles.n; i++)
    {
        const struct dem_particle *const q = &d->state.particles.record[i];
        const struct dem_edit_item *const l = dem_edit_find(e, q->id);
        const int part = !e->to && q->body && !l && dem_edit_find(e, q->body - 1);

        if (l)
        {
            present[l - e->item] = 1;
        }
        if (part || (l && !clump_allows(e, q)))
        {
            clumped[0] = q->id;
            clumped[1] = q->body - 1;
        }
    }
    dem_collect_max_uint8(&d->state.decomposition, present, (size_t)e->n);
    for (int64_t k = 0; k < e->n && missing < 0; k++)
    {
        missing = present[k] ? -1 : k;
    }
    dem_memory_free(present);
    DEM_REQUIRE(missing < 0, DEM_ERROR_INPUT,
                "%s: the run has no particle %lld; give ids of particles that it has", e->call,
                (long long)e->item[missing].id);
    status = clumped[0] < 0 ? DEM_OK
                            : dem_error(DEM_ERROR_INPUT, "%s: particle %lld is a sphere of the clump of particle %lld, "
                                        "which moves as one body; %s", e->call, (long long)clumped[0],
                                        (long long)clumped[1], e->to ? "give the id of that one, for the whole clump"
                                                                     : "give the ids of all its spheres");
    return dem_sim_agree(d, status);
}

/* ---- the edit -------------------------------------------------------------------------------- */

/* With lists: refuse overlaps; the elastic energy. */
static int look(struct dem *d)
{
    struct dem_state *const state = &d->state;
    struct dem_energy_balance *const l = state->energy_balance;

    int status = dem_sim_refuse_new_overlap(d);

    if (l->open)
    {
        DEM_TRY(dem_collect_agree(&state->decomposition, status));
        l->sums_elastic = 1;
        l->begun = 0;
        status = dem_sweep_contacts_and_bodies(state, 0.0, (const double[2]){state->time, state->time}, NULL);
        l->begun = 1;
    }
    return status;
}

/* What depends on all particles. */
static void finish(struct dem *d, struct dem_edit *e)
{
    struct dem_particles *const p = &d->state.particles;

    for (size_t i = 0; i < p->n; i++)
    {
        p->record[i].flags &= (uint16_t)~DEM_PARTICLE_NEW;
    }
    if (d->scene.fluid.given && e->lists)
    {
        dem_sim_init_fluid(d);
    }
    d->driven = dem_totals_any_driven(&d->state);
    d->state.energy_balance->driven |= d->driven;
    if (e->add.n > 0)
    {
        d->next_id = e->add.next_id;
        d->state.flows->next_id = d->state.flows->n > 0 ? e->add.next_id : 0;
    }
}

/* Save what belongs to the contact rows, and drop these. */
static int drop_rows(struct dem_state *state)
{
    DEM_TRY(dem_device_return_contacts(state, 1));
    if (state->lists_state != DEM_NEIGHBORS_NONE)
    {
        DEM_TRY(dem_wall_statistics_save_forces(state));
        DEM_TRY(dem_contacts_save_history(&state->contacts, &state->particles, state->pairs.wall_facet));
    }
    state->lists_state = DEM_NEIGHBORS_NONE;
    state->particles.ghosts = 0;
    return DEM_OK;
}

/* An edit after which the lists are built anew, on a copy of the state. */
static int change_lists(struct dem *d, const struct dem_edit *e)
{
    struct dem_state *const state = &d->state;
    struct dem_backup backup = {.valid = 0};
    int status = drop_rows(state);

    status = dem_sim_agree(d, status ? status
                                     : dem_backup_save(&backup, &state->particles, &state->contacts,
                                                       state->pairs.wall_facet));
    if (!status)
    {
        status = dem_sim_agree(d, e->change(d, e));
        status = status ? status : dem_sim_with_lists(d, look);
    }
    if (status && backup.valid)
    {
        d->failed |= dem_backup_restore(&backup, &state->particles, &state->contacts) != DEM_OK;
    }
    dem_backup_free(&backup);
    return status;
}

/* Collective: the arguments have been checked. The backup of the run is renewed: streams and outlets
   are copied into it when lists are built. */
static int apply(struct dem *d, struct dem_edit *e)
{
    struct dem_state *const state = &d->state;
    const double before = state->energy_balance->open ? dem_energy_balance_total(state) : 0.0;
    const int status = e->lists ? change_lists(d, e) : e->change(d, e);

    if (!status)
    {
        finish(d, e);
        dem_energy_balance_edited(state, before);
    }
    const int renewed = state->backup.valid && e->lists ? dem_step_backup(state) : DEM_OK;

    return status ? status : renewed;
}

int dem_edit_make(struct dem *d, struct dem_edit *e, int status)
{
    fenv_t caller;

    feholdexcept(&caller);
    status = dem_sim_agree(d, status);
    status = status || e->n == 0 ? status : apply(d, e);
    fesetenv(&caller);
    dem_memory_free(e->item);
    return status;
}
