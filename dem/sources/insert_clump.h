/*
 * insert_clump.h -- makes the rigid bodies of groups and streams of `insert`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "input/dictionary.h"
#include "particles/clump.h"
#include "particles/clump_shape.h"

struct dem_clump_source
{
    const struct dem_clump_shape *shape;    /* NULL: spheres */
    const double *orientation;              /* of all of them, a quaternion; NULL: random */
    const struct dem_domain *domain;
};

/* Read shape and orientation of a group, which may have neither. */
int dem_clump_source_read(struct dem_clump_source *, const struct dem_dict *group,
                          const struct dem_clump_shapes *, const struct dem_domain *,
                          const char *where);

/* Body `number`: the particle has its centre, velocity, spin, material and first id. */
void dem_clump_source_make(const struct dem_clump_source *, uint64_t seed, int64_t number,
                           double density, const struct dem_particle *, struct dem_clump *);

/* Sphere k of it, also its offset in the body. */
struct dem_particle dem_clump_source_sphere(const struct dem_clump_source *, double density,
                                            const struct dem_particle *, size_t k,
                                            struct dem_clump *);

/* Number of ids of a particle: of its spheres. */
static inline int64_t dem_clump_source_ids(const struct dem_clump_source *s)
{
    return s->shape ? (int64_t)s->shape->n : 1;
}

/* Solid volume [m3] of a particle of this diameter [m]. */
static inline double dem_clump_source_volume(const struct dem_clump_source *s, double diameter)
{
    return s->shape ? s->shape->volume : dem_sphere_volume(0.5*diameter);
}

/* Lower the smallest volume for the limit of the time step [m3] to a shape's; 0 means none yet. */
static inline void dem_clump_source_limit(const struct dem_clump_source *s, double *least)
{
    if (s->shape)
    {
        *least = *least > 0.0 && *least < s->shape->step_volume ? *least : s->shape->step_volume;
    }
}
