/*
 * edit_particles.c -- remove and change particles between two advances (run/edit.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/edit.h"
#include "core/error.h"
#include "core/memory.h"
#include "particles/scalars.h"
#include <math.h>
#include <string.h>

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

/* What is frozen comes to rest, unless the same call gives it a velocity or spin. */
static void set_motion(struct dem_particle *q, const struct dem_particle_changes *c, int64_t at)
{
    if (c->frozen && c->frozen[at] && !(q->flags & DEM_PARTICLE_FROZEN))
    {
        memset(q->v, 0, sizeof q->v);
        memset(q->w, 0, sizeof q->w);
    }
    dem_edit_set_vector(q->v, c->velocity, at);
    dem_edit_set_vector(q->w, c->spin, at);
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
    dem_edit_set_vector(q->x, e->to->position, at);
    q->flags |= e->to->position ? DEM_PARTICLE_NEW : 0;
    return e->to->position ? dem_edit_place(d, e->call, q) : DEM_OK;
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
        const int whole = dem_edit_moves(e) && p->record[i].body;
        const struct dem_edit_item *const own = dem_edit_find(e, p->record[i].id),
                                   *const l = whole ? dem_edit_find(e, p->record[i].body - 1) : own;
        struct dem_clump body = {.mass = 0.0};
        struct dem_particle q = p->record[i];

        DEM_TRY(l && whole ? dem_edit_set_clump(d, e, l->at, i, &q, &body) : DEM_OK);
        DEM_TRY(l && !whole ? set_one(d, e, l->at, &q) : DEM_OK);
        DEM_TRY(own ? check_scalar(d, e, q.id, own->at) : DEM_OK);
        DEM_TRY(check_clump(d, e, &q));
        if (l && write)
        {
            p->record[i] = q;
        }
        if (own && write)
        {
            set_scalar(p, e->to, i, own->at);
        }
        if (l && write && whole)
        {
            *dem_clump_at(p, i) = body;
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

int dem_remove_particles(struct dem *d, int64_t n, const int64_t *id)
{
    struct dem_edit e = {.call = "dem_remove_particles", .n = n, .change = remove_listed,
                         .lists = 1};
    int status = dem_edit_check_state(d, e.call);

    status = status ? status : dem_sim_require_count(e.call, "ids", n);
    status = status ? status : dem_edit_list(&e, id);
    return dem_edit_make(d, &e, dem_edit_require_present(d, &e, status));
}

int dem_set_particles(struct dem *d, int64_t n, const int64_t *id,
                      const struct dem_particle_changes *to)
{
    struct dem_edit e = {.call = "dem_set_particles", .n = n, .change = set_listed, .to = to,
                         .lists = to->position || to->frozen};
    int status = dem_edit_check_state(d, e.call);

    status = status ? status : dem_sim_require_count(e.call, "ids", n);
    status = status ? status : dem_edit_list(&e, id);
    status = dem_edit_require_present(d, &e, status);
    return dem_edit_make(d, &e, status ? status : go_through(d, &e, 0));
}
