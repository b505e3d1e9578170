/*
 * edit_clumps.c -- add and change rigid bodies of several spheres between two advances (run/edit.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/edit.h"
#include "core/error.h"
#include "core/memory.h"
#include "sources/insert_clump.h"
#include <fenv.h>
#include <math.h>
#include <string.h>

/* ---- to add ---------------------------------------------------------------------------------- */

/* The time step of the start is short enough for clumps of this shape and material. */
static int check_shape(const struct dem *d, const struct dem_new_clump *given, const struct dem_clump_shape *s,
                       int material)
{
    const double least = d->state.interaction_table.body_volume[material];

    DEM_REQUIRE(least > 0.0 && s->step_volume >= least*(1.0 - 1e-9), DEM_ERROR_INPUT,
                "dem_add_clumps: time step and lists are not made for clumps of shape %s and material %s; let the scene "
                "have a group or stream of them (Python: sim.change)", given->shape, given->material);
    return DEM_OK;
}

/* Centre and motion of a clump, as dem_clump_source_make takes them. */
static struct dem_particle whole(const struct dem_new_clump *given, int material, int64_t id)
{
    struct dem_particle q = {.id = id, .material = (uint16_t)material,
                             .flags = given->frozen ? DEM_PARTICLE_FROZEN : 0};

    memcpy(q.x, given->position, sizeof q.x);
    memcpy(q.v, given->velocity, sizeof q.v);
    memcpy(q.w, given->spin, sizeof q.w);
    return q;
}

static int check_numbers(const struct dem_new_clump *given)
{
    const double *const q = given->orientation;
    const double square = q[0]*q[0] + q[1]*q[1] + q[2]*q[2] + q[3]*q[3];
    double sum = square, speed = 0.0;

    for (int k = 0; k < 3; k++)
    {
        sum += given->position[k] + given->velocity[k] + given->spin[k];
        speed += fabs(given->velocity[k]) + fabs(given->spin[k]);
    }
    DEM_REQUIRE(isfinite(sum), DEM_ERROR_INPUT, "dem_add_clumps: a position, velocity, spin or orientation is not a "
                "number");
    DEM_REQUIRE(fabs(square - 1.0) < 1e-3, DEM_ERROR_INPUT, "dem_add_clumps: an orientation whose squares have the "
                "sum %g; give the four numbers of a unit quaternion, (1 0 0 0) for the shape as it is", square);
    DEM_REQUIRE(!given->frozen || speed == 0.0, DEM_ERROR_INPUT, "dem_add_clumps: a frozen clump never moves, but has "
                "a velocity or spin; leave it out, or frozen");
    return DEM_OK;
}

/* All spheres of one clump. */
static int check_new(struct dem *d, struct dem_edit *e, const struct dem_new_clump *given, int64_t *id)
{
    struct dem_initial_particles *const to = &e->add;
    struct dem_clump_source source = {.orientation = given->orientation, .domain = &d->state.domain};
    struct dem_clump body;
    int material;

    DEM_TRY(dem_interaction_table_find_material(&d->state.interaction_table, given->material, e->call, &material));
    DEM_TRY(dem_clump_shapes_find(&d->scene.shapes, given->shape, e->call, &source.shape));
    DEM_TRY(check_shape(d, given, source.shape, material));
    DEM_TRY(check_numbers(given));
    DEM_REQUIRE(given->id < 0 || given->id >= dem_edit_next_id(d), DEM_ERROR_INPUT,
                "%s: id %lld; the run has had ids up to %lld, and none is used twice: give a larger one, or none",
                e->call, (long long)given->id, (long long)dem_edit_next_id(d) - 1);
    const double density = d->state.interaction_table.material[material].density;
    struct dem_particle centre = whole(given, material, given->id < 0 ? to->next_id : given->id);

    *id = centre.id;
    DEM_TRY(dem_edit_place(d, e->call, &centre));
    dem_clump_source_make(&source, 0, 0, density, &centre, &body);
    for (size_t k = 0; k < source.shape->n; k++)
    {
        const struct dem_particle q = dem_clump_source_sphere(&source, density, &centre, k, &body);

        DEM_TRY(dem_initial_particles_add(to, q, e->call));
        to->clump[to->n - 1] = body;
        dem_domain_wrap(&d->state.domain, &to->particle[to->n - 1]);
        to->particle[to->n - 1].image = 0;
        DEM_TRY(dem_edit_check_radius(d, e->call, &q));
    }
    return dem_clump_check_spin(&body, &to->particle[to->n - 1], d->step, DEM_ERROR_INPUT);
}

/* `id` gets the first id of each. */
static int check_all_new(struct dem *d, struct dem_edit *e, const struct dem_new_clump *new, int64_t *id)
{
    DEM_REQUIRE(d->scene.shapes.n > 0, DEM_ERROR_INPUT, "%s: the scene has no shapes; add the entry shapes", e->call);
    e->add.next_id = dem_edit_next_id(d);
    e->add.has_clumps = 1;
    dem_initial_particles_have_scalars(&e->add, &d->state.interaction_table);
    for (int64_t k = 0; k < e->n; k++)
    {
        DEM_TRY(check_new(d, e, &new[k], &id[k]));
    }
    e->n = (int64_t)e->add.n;
    DEM_TRY(DEM_NEW(e->id, e->n + 1));
    for (int64_t k = 0; k < e->n; k++)
    {
        e->id[k] = e->add.particle[k].id;
    }
    return dem_edit_list(e, e->id);
}

int dem_add_clumps(struct dem *d, int64_t n, const struct dem_new_clump *new, int64_t *id)
{
    struct dem_edit e = {.call = "dem_add_clumps", .n = n, .change = dem_edit_add, .lists = 1};
    int64_t *first = NULL;
    fenv_t caller;
    int status = dem_edit_check_state(d, e.call);

    status = status ? status : dem_sim_require_count(e.call, "clumps", n);
    status = status ? status : DEM_NEW(first, n + 1);
    feholdexcept(&caller);
    status = status ? status : check_all_new(d, &e, new, first);
    fesetenv(&caller);
    status = dem_edit_make(d, &e, status);
    if (id && n > 0 && !status)
    {
        memcpy(id, first, (size_t)n*sizeof *id);
    }
    dem_memory_free(first);
    dem_memory_free(e.id);
    dem_initial_particles_free(&e.add);
    return status;
}

/* ---- to change ------------------------------------------------------------------------------- */

static void set_spin(struct dem_clump *b, const double w[3])
{
    double own[3];

    dem_clump_rotate_back(b->q, w, own);
    for (int k = 0; k < 3; k++)
    {
        own[k] *= b->inertia[k];
    }
    dem_clump_rotate(b->q, own, b->momentum);
}

static int check_motion(const struct dem *d, const struct dem_edit *e, const struct dem_particle *q,
                        const struct dem_clump *b, const double w[3])
{
    DEM_REQUIRE(isfinite(dem_vec_dot(b->v, b->v) + dem_vec_dot(w, w)) && dem_vec_norm(b->v) < dem_particle_max_speed,
                DEM_ERROR_INPUT, "%s: the clump of particle %lld gets the velocity (%g %g %g) m/s; give one below the "
                "speed of light", e->call, (long long)q->id, b->v[0], b->v[1], b->v[2]);
    DEM_REQUIRE(!(q->flags & DEM_PARTICLE_FROZEN) || dem_vec_dot(b->v, b->v) + dem_vec_dot(w, w) == 0.0,
                DEM_ERROR_INPUT, "%s: the clump of particle %lld is frozen, and clumps are not driven; leave out its "
                "velocity and spin, or free it", e->call, (long long)q->id);
    return dem_clump_check_spin(b, q, d->step, DEM_ERROR_INPUT);
}

int dem_edit_set_clump(const struct dem *d, const struct dem_edit *e, int64_t at, size_t i, struct dem_particle *q,
                       struct dem_clump *b)
{
    const struct dem_particle_changes *const c = e->to;
    struct dem_particle centre = {.id = q->id, .radius = q->radius};
    double w[3];

    *b = *dem_clump_at(&d->state.particles, i);
    dem_clump_spin(b, w);
    if (c->frozen && c->frozen[at])
    {
        memset(b->v, 0, sizeof b->v);
        memset(w, 0, sizeof w);
    }
    if (c->frozen)
    {
        q->flags = (uint16_t)((q->flags & ~DEM_PARTICLE_FROZEN) | (c->frozen[at] ? DEM_PARTICLE_FROZEN : 0));
        q->inverse_mass = c->frozen[at] ? 0.0 : 1.0/b->mass;
        q->inverse_inertia = c->frozen[at] ? 0.0 : 3.0/(b->inertia[0] + b->inertia[1] + b->inertia[2]);
    }
    dem_edit_set_vector(b->v, c->velocity, at);
    dem_edit_set_vector(w, c->spin, at);
    set_spin(b, w);
    DEM_TRY(check_motion(d, e, q, b, w));
    if (c->position)
    {
        dem_edit_set_vector(centre.x, c->position, at);
        DEM_TRY(dem_edit_place(d, e->call, &centre));
        memcpy(b->x, centre.x, sizeof b->x);
        q->flags |= DEM_PARTICLE_NEW;
    }
    const struct dem_particle was = *q;

    dem_clump_put(b, &d->state.domain, q);
    if (c->position)
    {
        dem_domain_wrap(&d->state.domain, q);
        q->image = 0;
    }
    else
    {
        memcpy(q->x, was.x, sizeof q->x);
    }
    return DEM_OK;
}
