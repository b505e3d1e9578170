/*
 * edit_particles.c -- add, remove and change particles between two advances.
 *
 * An edit has these parts; after an error the state is put back from a copy:
 *
 *   1. check the arguments
 *   2. save the contact history and the forces on walls, and drop the contact rows: the next step
 *      rebuilds the lists and sends particles to their owners
 *   3. change the particles that this rank owns
 *   4. on a backup, build the lists: refuse overlaps of particles that are new or were moved, and
 *      evaluate the elastic energy for the energy balance
 *
 * Velocities and spins alone change nothing but the records. The first half kick of the next advance
 * takes the contact forces from the columns of the particles, 0 for those that are new or moved.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/dem_case.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "particles/orientation.h"
#include "particles/scalars.h"
#include "ranks/collect.h"
#include "records/energy_balance.h"
#include "records/totals.h"
#include "records/wall_statistics.h"
#include "sources/flows.h"
#include "step/step_backup.h"
#include "step/sweep_contacts.h"
#include <fenv.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct listed            /* an id of the call and where it stands in the list */
{
    int64_t id, at;
};

struct edit
{
    const char *call;
    int64_t n;
    struct listed *listed;                      /* by id */
    const struct dem_new_particle *new;         /* to add; NULL: none */
    struct dem_initial_particles add;           /* the same, checked */
    int64_t *id;                                /* and their ids */
    const struct dem_particle_changes *change;  /* NULL: none */
    int lists;                                  /* 1: the lists change */
};

/* ---- checks ---------------------------------------------------------------------------------- */

static int check_state(const struct dem *d, const char *call)
{
    const struct dem_window *const w = &d->state.window;

    DEM_TRY(dem_api_require_sound(d, call));
    DEM_REQUIRE(!d->coupled, DEM_ERROR_STATE,
                "%s: the run is coupled with a fluid, which has to know of all particles; use "
                "streams and outlets", call);
    DEM_REQUIRE(!w->half_step_ahead, DEM_ERROR_STATE,
                "%s: the last advance was stopped before its end; advance by the rest of it, %.17g "
                "s, first", call, w->start + w->length - d->state.time);
    return DEM_OK;
}

static int by_id(const void *a, const void *b)
{
    const struct listed *const p = a, *const q = b;

    return (p->id > q->id) - (p->id < q->id);
}

static const struct listed *find(const struct edit *e, int64_t id)
{
    const struct listed key = {.id = id};

    return e->n > 0 ? bsearch(&key, e->listed, (size_t)e->n, sizeof key, by_id) : NULL;
}

/* The ids of the call, each once. */
static int list_ids(struct edit *e, const int64_t *id)
{
    DEM_TRY(DEM_NEW(e->listed, e->n + 1));
    for (int64_t k = 0; k < e->n; k++)
    {
        e->listed[k] = (struct listed){id[k], k};
    }
    dem_sort_by(e->listed, (size_t)e->n, sizeof *e->listed, by_id);
    for (int64_t k = 1; k < e->n; k++)
    {
        DEM_REQUIRE(e->listed[k].id != e->listed[k - 1].id, DEM_ERROR_INPUT,
                    "%s: id %lld stands twice in the list; give each id once", e->call,
                    (long long)e->listed[k].id);
    }
    return DEM_OK;
}

/* Collective. The run has all these particles. */
static int check_present(struct dem *d, const struct edit *e, int status)
{
    uint8_t *present = NULL;
    int64_t missing = -1;

    DEM_TRY(dem_api_agree(d, status ? status : DEM_NEW(present, e->n + 1)));
    for (size_t i = 0; i < d->state.particles.n; i++)
    {
        const struct listed *const l = find(e, d->state.particles.record[i].id);

        if (l)
        {
            present[l - e->listed] = 1;
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
                (long long)e->listed[missing].id);
    return DEM_OK;
}

/* ---- particles to add ------------------------------------------------------------------------ */

/* Time step, lists and constants of the laws follow from the radii of the start. */
static int check_radius(const struct dem *d, const char *call, const struct dem_particle *q)
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

/* Set the position; a particle outside the domain is refused. */
static int place(const struct dem *d, const char *call, struct dem_particle *q)
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

/* The first id that no particle has had. */
static int64_t next_id(const struct dem *d)
{
    return d->next_id > d->state.flows->next_id ? d->next_id : d->state.flows->next_id;
}

static int check_new(struct dem *d, struct edit *e, int64_t k)
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
    DEM_REQUIRE(q.id < 0 || q.id >= next_id(d), DEM_ERROR_INPUT,
                "%s: id %lld; the run has had ids up to %lld, and none is used twice: give a larger "
                "one, or none", e->call, (long long)q.id, (long long)next_id(d) - 1);
    DEM_TRY(dem_initial_particles_add(to, q, e->call));
    struct dem_particle *const added = &to->particle[to->n - 1];

    DEM_TRY(check_radius(d, e->call, added));
    return place(d, e->call, added);
}

static int check_all_new(struct dem *d, struct edit *e)
{
    e->add.next_id = next_id(d);
    dem_initial_particles_have_scalars(&e->add, &d->state.interaction_table);
    DEM_TRY(DEM_NEW(e->id, e->n + 1));
    for (int64_t k = 0; k < e->n; k++)
    {
        DEM_TRY(check_new(d, e, k));
        e->id[k] = e->add.particle[k].id;
    }
    return list_ids(e, e->id);
}

static int add(struct dem *d, const struct edit *e)
{
    struct dem_state *const p = &d->state;

    for (size_t k = 0; k < e->add.n; k++)
    {
        const struct dem_particle *const q = &e->add.particle[k];

        if (p->decomposition.ranks > 1 &&
            dem_decomposition_owner(&p->decomposition, q->x) != p->decomposition.rank)
        {
            continue;
        }
        DEM_TRY(dem_particles_add(&p->particles, q));
        p->particles.record[p->particles.n - 1].flags |= DEM_PARTICLE_NEW;
        for (int m = 0; m < e->add.scalars; m++)
        {
            dem_scalar_values(&p->particles, m)[p->particles.n - 1] = e->add.default_scalar[m];
        }
        dem_flows_begin_columns(p, p->particles.n - 1, &d->scene.fluid);
    }
    dem_orientation_begin(&p->particles);
    return DEM_OK;
}

/* ---- particles to remove or to change -------------------------------------------------------- */

static int remove_listed(struct dem *d, const struct edit *e)
{
    struct dem_particles *const p = &d->state.particles;
    uint32_t *order;
    int64_t *id;
    size_t kept = 0;

    DEM_TRY(DEM_NEW(order, p->n + 1));
    for (size_t i = 0; i < p->n; i++)
    {
        if (!find(e, p->record[i].id))
        {
            order[kept++] = (uint32_t)i;
        }
    }
    if (kept < p->n)
    {
        dem_particles_reorder(p, order, kept);
    }
    dem_memory_free(order);
    DEM_TRY(DEM_NEW(id, e->n + 1));
    for (int64_t k = 0; k < e->n; k++)
    {
        id[k] = e->listed[k].id;
    }
    dem_contact_history_drop(&d->state.contacts.history, id, (size_t)e->n);
    dem_memory_free(id);
    return DEM_OK;
}

static void set_vector(double to[3], const double *values, int64_t at)
{
    if (values)
    {
        memcpy(to, values + 3*at, 3*sizeof *to);
    }
}

/* What is frozen comes to rest, unless the same call gives it a velocity or spin. */
static void set_motion(struct dem_particle *q, const struct dem_particle_changes *c, int64_t at)
{
    if (c->frozen && c->frozen[at] && !(q->flags & DEM_PARTICLE_FROZEN))
    {
        memset(q->v, 0, sizeof q->v);
        memset(q->w, 0, sizeof q->w);
    }
    set_vector(q->v, c->velocity, at);
    set_vector(q->w, c->spin, at);
    const int frozen = c->frozen ? c->frozen[at] : q->flags & DEM_PARTICLE_FROZEN;
    const int moves = dem_vec_dot(q->v, q->v) + dem_vec_dot(q->w, q->w) > 0.0;

    q->flags &= (uint16_t)~(DEM_PARTICLE_FROZEN | DEM_PARTICLE_DRIVEN);
    q->flags |= (uint16_t)(frozen ? DEM_PARTICLE_FROZEN : 0);
    q->flags |= (uint16_t)(frozen && moves ? DEM_PARTICLE_DRIVEN : 0);
    if (c->frozen)
    {
        q->inverse_mass = frozen ? 0.0 : 1.0/q->mass;
        q->inverse_inertia = frozen ? 0.0 : 1.0/(0.4*q->mass*q->radius*q->radius);
    }
}

static int check_scalar(const struct dem *d, const struct edit *e, int64_t id, int64_t at)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;
    const int k = e->change->scalar;

    if (!e->change->value)
    {
        return DEM_OK;
    }
    DEM_REQUIRE(k >= 0 && k < r->scalars, DEM_ERROR_INPUT, "%s: there is no particle scalar %d; the run "
                "has %d", e->call, k, r->scalars);
    DEM_REQUIRE(e->change->value[at] >= r->scalar[k]->min && e->change->value[at] <= r->scalar[k]->max,
                DEM_ERROR_INPUT, "%s: particle %lld gets %s %g %s; give a number from %g to %g", e->call,
                (long long)id, r->scalar[k]->name, e->change->value[at], r->scalar[k]->unit,
                r->scalar[k]->min, r->scalar[k]->max);
    return DEM_OK;
}

/* The particle with its changes. */
static int set_one(const struct dem *d, const struct edit *e, int64_t at, struct dem_particle *q)
{
    set_motion(q, e->change, at);
    DEM_REQUIRE(isfinite(dem_vec_dot(q->v, q->v)) && dem_vec_norm(q->v) < dem_particle_max_speed,
                DEM_ERROR_INPUT, "%s: particle %lld gets the velocity (%g %g %g) m/s; give one below "
                "the speed of light", e->call, (long long)q->id, q->v[0], q->v[1], q->v[2]);
    DEM_TRY(dem_initial_particles_check_spin(e->call, q->w, q->radius));
    DEM_TRY(check_scalar(d, e, q->id, at));
    set_vector(q->x, e->change->position, at);
    q->flags |= e->change->position ? DEM_PARTICLE_NEW : 0;
    return e->change->position ? place(d, e->call, q) : DEM_OK;
}

/* A particle that was moved has no forces, and has not crossed what lay between. */
static void forget_way(struct dem_particles *p, size_t i)
{
    double *const checked = dem_column(p, DEM_COLUMN_CHECKED_POSITION);

    memset(dem_column(p, DEM_COLUMN_FORCE) + 3*i, 0, 3*sizeof(double));
    memset(dem_column(p, DEM_COLUMN_TORQUE) + 3*i, 0, 3*sizeof(double));
    if (checked)
    {
        memset(checked + 4*i, 0, 4*sizeof *checked);
    }
}

static void set_scalar(const struct dem_particles *p, const struct dem_particle_changes *c, size_t i,
                       int64_t at)
{
    if (c->value)
    {
        dem_scalar_values(p, c->scalar)[i] = c->value[at];
    }
}

/* write: 0: only check. */
static int set_listed(struct dem *d, const struct edit *e, int write)
{
    struct dem_particles *const p = &d->state.particles;

    for (size_t i = 0; i < p->n; i++)
    {
        const struct listed *const l = find(e, p->record[i].id);
        struct dem_particle q = p->record[i];

        DEM_TRY(l ? set_one(d, e, l->at, &q) : DEM_OK);
        if (l && write)
        {
            p->record[i] = q;
            set_scalar(p, e->change, i, l->at);
        }
        if (l && write && e->change->position)
        {
            forget_way(p, i);
        }
    }
    if (write)
    {
        dem_domain_constrain(&d->state.domain, p);
    }
    return DEM_OK;
}

/* ---- the edit -------------------------------------------------------------------------------- */

/* With lists: refuse overlaps; the elastic energy. */
static int look(struct dem *d)
{
    struct dem_state *const p = &d->state;
    struct dem_energy_balance *const l = p->energy_balance;
    int status = dem_api_refuse_new_overlap(d);

    if (l->open)
    {
        DEM_TRY(dem_collect_agree(&p->decomposition, status));
        l->sums_elastic = 1;
        l->begun = 0;
        status = dem_sweep_contacts_and_bodies(p, 0.0, (const double[2]){p->time, p->time}, NULL);
        l->begun = 1;
    }
    return status;
}

static int change(struct dem *d, const struct edit *e)
{
    return e->add.n > 0 ? add(d, e) : e->change ? set_listed(d, e, 1) : remove_listed(d, e);
}

/* What depends on all particles. */
static void finish(struct dem *d, struct edit *e)
{
    struct dem_particles *const p = &d->state.particles;

    for (size_t i = 0; i < p->n; i++)
    {
        p->record[i].flags &= (uint16_t)~DEM_PARTICLE_NEW;
    }
    if (d->scene.fluid.given && e->lists)
    {
        dem_api_init_fluid(d);
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
static int drop_rows(struct dem_state *p)
{
    if (p->stale < 2)
    {
        DEM_TRY(dem_wall_statistics_save_forces(p));
        DEM_TRY(dem_contacts_save_history(&p->contacts, &p->particles, p->pairs.wall_facet));
    }
    p->stale = 2;
    p->particles.ghosts = 0;
    return DEM_OK;
}

/* An edit after which the lists are built anew, on a copy of the state. */
static int change_lists(struct dem *d, const struct edit *e)
{
    struct dem_state *const p = &d->state;
    struct dem_backup backup = {.valid = 0};
    int status = drop_rows(p);

    status = dem_api_agree(d, status ? status
                                     : dem_backup_save(&backup, &p->particles, &p->contacts,
                                                       p->pairs.wall_facet));
    if (!status)
    {
        status = dem_api_agree(d, change(d, e));
        status = status ? status : dem_api_with_lists(d, look);
    }
    if (status && backup.valid)
    {
        d->failed |= dem_backup_restore(&backup, &p->particles, &p->contacts) != DEM_OK;
    }
    dem_backup_free(&backup);
    return status;
}

/* Collective: the arguments have been checked. The backup of the run is renewed: streams and outlets
   are copied into it when lists are built. */
static int apply(struct dem *d, struct edit *e)
{
    struct dem_state *const p = &d->state;
    const double before = p->energy_balance->open ? dem_energy_balance_total(p) : 0.0;

    DEM_TRY(dem_api_agree(d, e->change ? set_listed(d, e, 0) : DEM_OK));
    const int status = e->lists ? change_lists(d, e) : change(d, e);

    if (!status)
    {
        finish(d, e);
        dem_energy_balance_edited(p, before);
    }
    const int renewed = p->backup.valid && e->lists ? dem_step_backup(p) : DEM_OK;

    return status ? status : renewed;
}

/* Collective. `status`: of the checks of this rank. */
static int edit(struct dem *d, struct edit *e, int status)
{
    fenv_t caller;

    feholdexcept(&caller);
    status = dem_api_agree(d, status);
    status = status || e->n == 0 ? status : apply(d, e);
    fesetenv(&caller);
    dem_memory_free(e->listed);
    return status;
}

int dem_add_particles(struct dem *d, int64_t n, const struct dem_new_particle *new, int64_t *id)
{
    struct edit e = {.call = "dem_add_particles", .n = n, .new = new, .lists = 1};
    fenv_t caller;
    int status = check_state(d, e.call);

    status = status ? status : dem_api_require_count(e.call, "particles", n);
    feholdexcept(&caller);
    status = status ? status : check_all_new(d, &e);
    fesetenv(&caller);
    status = edit(d, &e, status);
    if (id && n > 0 && !status)
    {
        memcpy(id, e.id, (size_t)n*sizeof *id);
    }
    dem_memory_free(e.id);
    dem_initial_particles_free(&e.add);
    return status;
}

int dem_remove_particles(struct dem *d, int64_t n, const int64_t *id)
{
    struct edit e = {.call = "dem_remove_particles", .n = n, .lists = 1};
    int status = check_state(d, e.call);

    status = status ? status : dem_api_require_count(e.call, "ids", n);
    status = status ? status : list_ids(&e, id);
    return edit(d, &e, check_present(d, &e, status));
}

int dem_set_particles(struct dem *d, int64_t n, const int64_t *id,
                      const struct dem_particle_changes *change)
{
    struct edit e = {.call = "dem_set_particles", .n = n, .change = change,
                     .lists = change->position || change->frozen};
    int status = check_state(d, e.call);

    status = status ? status : dem_api_require_count(e.call, "ids", n);
    status = status ? status : list_ids(&e, id);
    return edit(d, &e, check_present(d, &e, status));
}
