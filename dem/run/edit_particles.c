/*
 * edit_particles.c -- add, remove and change particles between two advances (run/edit.h).
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
#include <math.h>
#include <string.h>

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
    DEM_REQUIRE(q.id < 0 || q.id >= next_id(d), DEM_ERROR_INPUT,
                "%s: id %lld; the run has had ids up to %lld, and none is used twice: give a larger "
                "one, or none", e->call, (long long)q.id, (long long)next_id(d) - 1);
    DEM_TRY(dem_initial_particles_add(to, q, e->call));
    struct dem_particle *const added = &to->particle[to->n - 1];

    DEM_TRY(check_radius(d, e->call, added));
    return place(d, e->call, added);
}

static int check_all_new(struct dem *d, struct dem_edit *e)
{
    e->add.next_id = next_id(d);
    dem_initial_particles_have_scalars(&e->add, &d->state.interaction_table);
    DEM_TRY(DEM_NEW(e->id, e->n + 1));
    for (int64_t k = 0; k < e->n; k++)
    {
        DEM_TRY(check_new(d, e, k));
        e->id[k] = e->add.particle[k].id;
    }
    return dem_edit_list(e, e->id);
}

static int add(struct dem *d, const struct dem_edit *e)
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

static int remove_listed(struct dem *d, const struct dem_edit *e)
{
    struct dem_particles *const p = &d->state.particles;
    uint32_t *order;
    int64_t *id;
    size_t kept = 0;

    DEM_TRY(DEM_NEW(order, p->n + 1));
    for (size_t i = 0; i < p->n; i++)
    {
        if (!dem_edit_find(e, p->record[i].id))
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
        id[k] = e->item[k].id;
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

static int check_scalar(const struct dem *d, const struct dem_edit *e, int64_t id, int64_t at)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;
    const int k = e->to->scalar;

    if (!e->to->value)
    {
        return DEM_OK;
    }
    DEM_REQUIRE(k >= 0 && k < r->scalars, DEM_ERROR_INPUT, "%s: there is no particle scalar %d; the run "
                "has %d", e->call, k, r->scalars);
    DEM_REQUIRE(e->to->value[at] >= r->scalar[k]->min && e->to->value[at] <= r->scalar[k]->max,
                DEM_ERROR_INPUT, "%s: particle %lld gets %s %g %s; give a number from %g to %g", e->call,
                (long long)id, r->scalar[k]->name, e->to->value[at], r->scalar[k]->unit,
                r->scalar[k]->min, r->scalar[k]->max);
    return DEM_OK;
}

/* A clump has one temperature: all its spheres are in the list, with the value of the first one, or none. */
static int check_clump(const struct dem *d, const struct dem_edit *e, const struct dem_particle *q)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;
    const int k = e->to->scalar;

    if (!q->body || !e->to->value || k < 0 || k >= r->scalars || !(r->scalar[k]->flags & DEM_SCALAR_HEAT))
    {
        return DEM_OK;
    }
    const struct dem_edit_item *const own = dem_edit_find(e, q->id), *const first = dem_edit_find(e, q->body - 1);

    DEM_REQUIRE(!own == !first && (!own || e->to->value[own->at] == e->to->value[first->at]), DEM_ERROR_INPUT,
                "%s: particle %lld is a sphere of a clump, which has one %s; give the same to all its spheres, "
                "from particle %lld on", e->call, (long long)q->id, r->scalar[k]->name, (long long)q->body - 1);
    return DEM_OK;
}

/* The particle with its changes. */
static int set_one(const struct dem *d, const struct dem_edit *e, int64_t at, struct dem_particle *q)
{
    set_motion(q, e->to, at);
    DEM_REQUIRE(isfinite(dem_vec_dot(q->v, q->v)) && dem_vec_norm(q->v) < dem_particle_max_speed,
                DEM_ERROR_INPUT, "%s: particle %lld gets the velocity (%g %g %g) m/s; give one below "
                "the speed of light", e->call, (long long)q->id, q->v[0], q->v[1], q->v[2]);
    DEM_TRY(dem_initial_particles_check_spin(e->call, q->w, q->radius));
    DEM_TRY(check_scalar(d, e, q->id, at));
    set_vector(q->x, e->to->position, at);
    q->flags |= e->to->position ? DEM_PARTICLE_NEW : 0;
    return e->to->position ? place(d, e->call, q) : DEM_OK;
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
static int go_through(struct dem *d, const struct dem_edit *e, int write)
{
    struct dem_particles *const p = &d->state.particles;

    for (size_t i = 0; i < p->n; i++)
    {
        const struct dem_edit_item *const l = dem_edit_find(e, p->record[i].id);
        struct dem_particle q = p->record[i];

        DEM_TRY(l ? set_one(d, e, l->at, &q) : DEM_OK);
        DEM_TRY(check_clump(d, e, &q));
        if (l && write)
        {
            p->record[i] = q;
            set_scalar(p, e->to, i, l->at);
        }
        if (l && write && e->to->position)
        {
            forget_way(p, i);
        }
    }
    return DEM_OK;
}

static int set_listed(struct dem *d, const struct dem_edit *e)
{
    DEM_TRY(go_through(d, e, 1));
    dem_domain_constrain(&d->state.domain, &d->state.particles);
    return DEM_OK;
}

int dem_add_particles(struct dem *d, int64_t n, const struct dem_new_particle *new, int64_t *id)
{
    struct dem_edit e = {.call = "dem_add_particles", .n = n, .new = new, .change = add, .lists = 1};
    fenv_t caller;
    int status = dem_edit_check_state(d, e.call);

    status = status ? status : dem_api_require_count(e.call, "particles", n);
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

int dem_remove_particles(struct dem *d, int64_t n, const int64_t *id)
{
    struct dem_edit e = {.call = "dem_remove_particles", .n = n, .change = remove_listed,
                         .lists = 1};
    int status = dem_edit_check_state(d, e.call);

    status = status ? status : dem_api_require_count(e.call, "ids", n);
    status = status ? status : dem_edit_list(&e, id);
    return dem_edit_make(d, &e, dem_edit_require_present(d, &e, status));
}

int dem_set_particles(struct dem *d, int64_t n, const int64_t *id,
                      const struct dem_particle_changes *to)
{
    struct dem_edit e = {.call = "dem_set_particles", .n = n, .change = set_listed, .to = to,
                         .lists = to->position || to->frozen};
    int status = dem_edit_check_state(d, e.call);

    status = status ? status : dem_api_require_count(e.call, "ids", n);
    status = status ? status : dem_edit_list(&e, id);
    status = dem_edit_require_present(d, &e, status);
    return dem_edit_make(d, &e, status ? status : go_through(d, &e, 0));
}
