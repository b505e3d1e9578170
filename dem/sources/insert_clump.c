/*
 * insert_clump.c -- rigid bodies in a group of `insert`: reads shape and orientation, makes the spheres of
 * a body.
 *
 *     nuts { type random; material wood; shape nut; count 200; seed 1; ... }
 *
 * A body is placed like the sphere around its centre that holds it in any orientation. The orientation
 * is random, a function of (seed, number), or the same for all: orientation (w x y z), a quaternion
 * that turns the shape as the scene gives it.
 *
 * A uniform random rotation is a point of the unit sphere in four dimensions: random points of the
 * cube are drawn until one lies within the sphere (Marsaglia, Ann. Math. Stat. 43 (1972) 645).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/insert_group.h"
#include "core/error.h"
#include "core/random.h"
#include <math.h>
#include <string.h>

enum
{
    USE_ORIENTATION = 301         /* stream of random numbers */
};

/* Entries of a group that bodies do not have. */
static int refuse_others(const struct dem_insert_group *b)
{
    static const char *const none[] = {"diameter", "diameters", "sizes", "ids"};

    for (size_t k = 0; k < sizeof none/sizeof *none; k++)
    {
        DEM_REQUIRE(!dem_dict_has(b->dict, none[k]), DEM_ERROR_INPUT,
                    "%s: the group has a shape and %s, which is for spheres; leave it out", b->where,
                    none[k]);
    }
    DEM_REQUIRE(!b->frozen && !b->driven, DEM_ERROR_INPUT,
                "%s: clumps are neither frozen nor driven; leave it out, or make a wall of triangles",
                b->where);
    return DEM_OK;
}

int dem_insert_group_read_clump(struct dem_insert_group *b, const struct dem_insertion *i)
{
    const char *name;
    size_t n;

    b->domain = i->domain;
    if (!dem_dict_has(b->dict, "shape"))
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_word(b->dict, "shape", &name));
    DEM_TRY(dem_clump_shapes_find(i->shapes, name, b->where, &b->clump));
    DEM_TRY(refuse_others(b));
    if (dem_dict_has(b->dict, "orientation"))
    {
        DEM_TRY(dem_dict_numbers(b->dict, "orientation", "1", &b->orientation, &n));
        double square = 0.0;

        for (size_t k = 0; k < n; k++)
        {
            square += b->orientation[k]*b->orientation[k];
        }
        DEM_REQUIRE(n == 4 && fabs(square - 1.0) < 1e-3, DEM_ERROR_INPUT,
                    "%s: orientation has %zu numbers with squares of sum %g; give the four of a unit "
                    "quaternion, (1 0 0 0) for the shape as it is", b->where, n, square);
    }
    return DEM_OK;
}

static void orient(const struct dem_insert_group *b, int64_t number, double q[4])
{
    double turn[4], square = 0.0;

    for (uint64_t draw = 0; !b->orientation && !(square > 1e-4 && square <= 1.0); draw++)
    {
        square = 0.0;
        for (int k = 0; k < 4; k++)
        {
            turn[k] = 2.0*dem_random_unit((uint64_t)b->seed, (uint64_t)number, draw,
                                          USE_ORIENTATION + (uint64_t)k) - 1.0;
            square += turn[k]*turn[k];
        }
    }
    dem_clump_product(b->orientation ? b->orientation : turn, b->clump->principal, q);
    const double scale = 1.0/sqrt(q[0]*q[0] + q[1]*q[1] + q[2]*q[2] + q[3]*q[3]);

    for (int k = 0; k < 4; k++)
    {
        q[k] *= scale;
    }
}

/* The body at rest in its axes, moving as the particle does. */
static struct dem_clump make(const struct dem_insert_group *b, double density,
                             const struct dem_particle *p, int64_t number)
{
    const struct dem_clump_shape *const s = b->clump;
    struct dem_particle centre = *p;
    struct dem_clump new = {.mass = density*s->volume};
    double spin[3], momentum[3];

    dem_domain_wrap(b->domain, &centre);
    memcpy(new.x, centre.x, sizeof new.x);
    memcpy(new.v, p->v, sizeof new.v);
    orient(b, number, new.q);
    dem_clump_rotate_back(new.q, p->w, spin);
    for (int k = 0; k < 3; k++)
    {
        new.inertia[k] = density*s->inertia[k];
        momentum[k] = new.inertia[k]*spin[k];
    }
    dem_clump_rotate(new.q, momentum, new.momentum);
    return new;
}

int dem_insert_group_add_clump(struct dem_initial_particles *c, const struct dem_insert_group *b,
                               const struct dem_interaction_table *r, const struct dem_particle *p,
                               int64_t number)
{
    const struct dem_clump_shape *const s = b->clump;
    const double density = r->material[b->material].density;
    struct dem_clump body = make(b, density, p, number);

    for (size_t k = 0; k < s->n; k++)
    {
        struct dem_particle q =
            dem_particle_sphere(p->id + (int64_t)k, p->x, 2.0*s->sphere[k][3], density, b->material);

        memcpy(body.offset, s->offset[k], sizeof body.offset);
        q.mass *= s->volume/s->solid;
        q.inverse_mass = 1.0/body.mass;
        q.inverse_inertia = 3.0/(body.inertia[0] + body.inertia[1] + body.inertia[2]);
        q.body = p->id + 1;
        dem_clump_put(&body, b->domain, &q);
        DEM_TRY(dem_initial_particles_add(c, q, b->where));
        c->clump[c->n - 1] = body;
    }
    return DEM_OK;
}
