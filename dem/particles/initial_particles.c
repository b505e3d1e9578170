/*
 * initial_particles.c -- add initial particles one by one, with checks, and sum up each group.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/initial_particles.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

void dem_initial_particles_free(struct dem_initial_particles *c)
{
    dem_memory_free(c->particle);
    dem_memory_free(c->scalar);
    dem_memory_free(c->clump);
    dem_memory_free(c->group);
    memset(c, 0, sizeof *c);
}

void dem_initial_particles_release(struct dem_initial_particles *c)
{
    dem_memory_free(c->particle);
    dem_memory_free(c->scalar);
    dem_memory_free(c->clump);
    c->particle = NULL;
    c->scalar = NULL;
    c->clump = NULL;
    c->n = c->capacity = c->scalar_capacity = c->clump_capacity = 0;
}

void dem_initial_particles_have_scalars(struct dem_initial_particles *c,
                                        const struct dem_interaction_table *r)
{
    c->scalars = r->scalars;
    for (int k = 0; k < r->scalars; k++)
    {
        c->default_scalar[k] = dem_interaction_table_default(r, k);
    }
}

int dem_initial_particles_begin_group(struct dem_initial_particles *c, const char *group)
{
    DEM_TRY(DEM_GROW(c->group, c->group_capacity, c->groups + 1));
    c->group[c->groups] = (struct dem_group_summary){.min_diameter = INFINITY};
    snprintf(c->group[c->groups++].name, sizeof c->group->name, "%s", group);
    return DEM_OK;
}

void dem_initial_particles_count(struct dem_initial_particles *c, int64_t n, double diameter,
                                 double volume, double mass, int material)
{
    struct dem_group_summary *const g = &c->group[c->groups - 1];

    g->material = g->n == 0 || g->material == material ? material : -1;
    g->n += n;
    g->min_diameter = fmin(g->min_diameter, diameter);
    g->max_diameter = fmax(g->max_diameter, diameter);
    g->sum += (double)n*diameter;
    g->volume += (double)n*volume;
    g->mass += (double)n*mass;
}

/* By components first: the square of a huge spin overflows. */
int dem_initial_particles_check_spin(const char *where, const double w[3], double radius)
{
    const double most = dem_particle_max_speed/radius;

    DEM_REQUIRE(fmax(fabs(w[0]), fmax(fabs(w[1]), fabs(w[2]))) <= most && dem_vec_norm(w) <= most,
                DEM_ERROR_INPUT,
                "%s: a particle of radius %g m has spin (%g %g %g) 1/s; the limit is %g 1/s, at "
                "which its surface moves at the speed of light; give a smaller spin",
                where, radius, w[0], w[1], w[2], most);
    return DEM_OK;
}

int dem_initial_particles_add(struct dem_initial_particles *c, struct dem_particle p,
                              const char *where)
{
    DEM_REQUIRE(p.radius > 0.0 && isfinite(p.radius), DEM_ERROR_INPUT,
                "%s: diameter %g m; give a number above 0", where, 2.0*p.radius);
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(isfinite(p.x[k] + p.v[k] + p.w[k]), DEM_ERROR_INPUT,
                    "%s: a position, velocity or spin is not a number", where);
        DEM_REQUIRE(fabs(p.x[k]) <= dem_max_distance*p.radius, DEM_ERROR_INPUT,
                    "%s: particle %lld at (%g %g %g) m is more than %g radii of %g m from the "
                    "origin, where overlaps are lost in rounding; move it",
                    where, (long long)p.id, p.x[0], p.x[1], p.x[2], dem_max_distance, p.radius);
        DEM_REQUIRE((p.flags & (DEM_PARTICLE_FROZEN | DEM_PARTICLE_DRIVEN)) != DEM_PARTICLE_FROZEN || (p.v[k] == 0.0 && p.w[k] == 0.0),
                    DEM_ERROR_INPUT,
                    "%s: a frozen particle never moves, but has a velocity or spin of %g; leave it "
                    "out, or frozen",
                    where, p.v[k] != 0.0 ? p.v[k] : p.w[k]);
    }
    DEM_TRY(dem_initial_particles_check_spin(where, p.w, p.radius));
    p.id = p.id < 0 ? c->next_id : p.id;
    DEM_REQUIRE(p.id < INT64_MAX, DEM_ERROR_INPUT,
                "%s: id %lld leaves no next one; give a smaller number", where, (long long)p.id);
    DEM_TRY(DEM_GROW(c->particle, c->capacity, c->n + 1));
    c->next_id = p.id >= c->next_id ? p.id + 1 : c->next_id;
    c->particle[c->n++] = p;
    if (c->scalars > 0)
    {
        const size_t each = (size_t)c->scalars;

        DEM_TRY(DEM_GROW(c->scalar, c->scalar_capacity, c->n*each));
        memcpy(dem_initial_particles_last_scalars(c), c->default_scalar, each*sizeof *c->scalar);
    }
    if (c->has_clumps)
    {
        DEM_TRY(DEM_GROW(c->clump, c->clump_capacity, c->n));
        memset(&c->clump[c->n - 1], 0, sizeof *c->clump);
    }
    return DEM_OK;
}
