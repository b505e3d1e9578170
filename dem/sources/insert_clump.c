/*
 * insert_clump.c -- reads shape and orientation of a group or stream of `insert`; makes the spheres of a
 * rigid body.
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
#include "sources/insert_clump.h"
#include "core/error.h"
#include "core/random.h"
#include <math.h>
#include <string.h>

enum
{
    USE_ORIENTATION = 301         /* stream of random numbers */
};

/* Entries of a group that bodies do not have. */
static int refuse_others(const struct dem_dict *group, const char *where)
{
    static const char *const none[] = {"diameter", "diameters", "sizes", "ids"};

    for (size_t k = 0; k < sizeof none/sizeof *none; k++)
    {
        DEM_REQUIRE(!dem_dict_has(group, none[k]), DEM_ERROR_INPUT,
                    "%s: the group has a shape and %s, which is for spheres; leave it out", where,
                    none[k]);
    }
    return DEM_OK;
}

int dem_clump_source_read(struct dem_clump_source *s, const struct dem_dict *group,
                          const struct dem_clump_shapes *shapes, const struct dem_domain *domain,
                          const char *where)
{
    const char *name;
    double square = 0.0;
    size_t n;

    *s = (struct dem_clump_source){.domain = domain};
    if (!dem_dict_has(group, "shape"))
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_word(group, "shape", &name));
    DEM_TRY(dem_clump_shapes_find(shapes, name, where, &s->shape));
    DEM_TRY(refuse_others(group, where));
    if (dem_dict_has(group, "orientation"))
    {
        DEM_TRY(dem_dict_numbers(group, "orientation", "1", &s->orientation, &n));
        for (size_t k = 0; k < n; k++)
        {
            square += s->orientation[k]*s->orientation[k];
        }
        DEM_REQUIRE(n == 4 && fabs(square - 1.0) < 1e-3, DEM_ERROR_INPUT,
                    "%s: orientation has %zu numbers with squares of sum %g; give the four of a unit "
                    "quaternion, (1 0 0 0) for the shape as it is", where, n, square);
    }
    return DEM_OK;
}

static void orient(const struct dem_clump_source *s, uint64_t seed, int64_t number, double q[4])
{
    double turn[4], square = 0.0;

    for (uint64_t draw = 0; !s->orientation && !(square > 1e-4 && square <= 1.0); draw++)
    {
        square = 0.0;
        for (int k = 0; k < 4; k++)
        {
            turn[k] = 2.0*dem_random_unit(seed, (uint64_t)number, draw,
                                          USE_ORIENTATION + (uint64_t)k) - 1.0;
            square += turn[k]*turn[k];
        }
    }
    dem_clump_product(s->orientation ? s->orientation : turn, s->shape->principal, q);
    const double scale = 1.0/sqrt(q[0]*q[0] + q[1]*q[1] + q[2]*q[2] + q[3]*q[3]);

    for (int k = 0; k < 4; k++)
    {
        q[k] *= scale;
    }
}

void dem_clump_source_make(const struct dem_clump_source *s, uint64_t seed, int64_t number,
                           double density, const struct dem_particle *p, struct dem_clump *new)
{
    struct dem_particle centre = *p;
    double spin[3], momentum[3];

    *new = (struct dem_clump){.mass = density*s->shape->volume};
    dem_domain_wrap(s->domain, &centre);
    memcpy(new->x, centre.x, sizeof new->x);
    memcpy(new->v, p->v, sizeof new->v);
    orient(s, seed, number, new->q);
    dem_clump_rotate_back(new->q, p->w, spin);
    for (int k = 0; k < 3; k++)
    {
        new->inertia[k] = density*s->shape->inertia[k];
        momentum[k] = new->inertia[k]*spin[k];
    }
    dem_clump_rotate(new->q, momentum, new->momentum);
}

struct dem_particle dem_clump_source_sphere(const struct dem_clump_source *s, double density,
                                            const struct dem_particle *p, size_t k,
                                            struct dem_clump *body)
{
    struct dem_particle q = dem_particle_sphere(p->id + (int64_t)k, p->x, 2.0*s->shape->sphere[k][3],
                                                density, p->material);

    memcpy(body->offset, s->shape->offset[k], sizeof body->offset);
    q.mass = density*s->shape->volume*s->shape->share[k];
    q.inverse_mass = 1.0/body->mass;
    q.inverse_inertia = 3.0/(body->inertia[0] + body->inertia[1] + body->inertia[2]);
    q.body = p->id + 1;
    if (p->flags & DEM_PARTICLE_FROZEN)
    {
        q.flags = p->flags;
        q.inverse_mass = q.inverse_inertia = 0.0;
    }
    dem_clump_put(body, s->domain, &q);
    return q;
}
