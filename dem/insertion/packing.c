/*
 * packing.c -- place spheres at random without overlap, up to a solid fraction of 0.57.
 *
 * 1. Decompose the shape among ranks; collect the spheres of earlier groups that reach into it.
 * 2. Random sequential addition, largest spheres first (packing_addition.c).
 * 3. Remove the remaining overlaps by pairwise relaxation (packing_relax.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "insertion/packing.h"
#include "core/error.h"
#include "core/memory.h"
#include "parallel/collect.h"
#include "parallel/mpi_error.h"
#include <math.h>
#include <string.h>

/* 0.58 takes three times as long as 0.55; random close packing is 0.64 */
static const double max_fraction = 0.57;

int dem_packing_check_fraction(const struct dem_insertion_shape *v, double volume, double n,
                               const char *where)
{
    const double fraction = volume/dem_insertion_shape_volume(v);

    DEM_REQUIRE(fraction <= max_fraction, DEM_ERROR_INPUT,
                "%s: %.10g particles at random are a solid fraction of %.3g, the limit is %g; "
                "enlarge the region, ask for fewer, use type lattice, or let a looser packing "
                "settle", where, n, fraction,
                max_fraction);
    return DEM_OK;
}

static double diameter_of(const struct dem_packing *p, int64_t m)
{
    return p->diameters ? p->diameters[m] : p->diameter;
}

static int reaches_into(const struct dem_insertion_shape *v, const struct dem_particle *q)
{
    int reaches = 1;

    for (int k = 0; k < 3; k++)
    {
        reaches &= q->x[k] + q->radius > v->min[k] && q->x[k] - q->radius < v->max[k];
    }
    return reaches;
}

/* The largest radius of all, and that of each grid level. The new spheres are known on all ranks,
   earlier groups only in part. *mean is the mean diameter of the new spheres. */
static int find_sizes(const struct dem_packing *p, const struct dem_initial_particles *c,
                      struct dem_placed_spheres *s, double *mean)
{
    double sum = 0.0, max[DEM_PLACED_SPHERE_LEVELS];

    for (int64_t m = 0; m < (p->diameters ? p->n : 1); m++)
    {
        s->max_radius = fmax(s->max_radius, 0.5*diameter_of(p, m));
        sum += diameter_of(p, m);
    }
    for (size_t k = 0; k < c->n; k++)
    {
        s->max_radius = reaches_into(p->shape, &c->particle[k])
                          ? fmax(s->max_radius, c->particle[k].radius)
                          : s->max_radius;
    }
    if (s->decomposition.ranks > 1)
    {
        DEM_TRY_MPI(MPI_Allreduce(MPI_IN_PLACE, &s->max_radius, 1, MPI_DOUBLE, MPI_MAX,
                                  s->decomposition.comm));
    }
    for (int64_t m = 0; m < (p->diameters ? p->n : 1); m++)
    {
        dem_placed_spheres_include_radius(s, 0.5*diameter_of(p, m));
    }
    for (size_t k = 0; k < c->n; k++)
    {
        if (reaches_into(p->shape, &c->particle[k]))
        {
            dem_placed_spheres_include_radius(s, c->particle[k].radius);
        }
    }
    for (int k = 0; k < DEM_PLACED_SPHERE_LEVELS && s->decomposition.ranks > 1; k++)
    {
        max[k] = s->level[k].max_radius;
    }
    if (s->decomposition.ranks > 1)
    {
        DEM_TRY_MPI(MPI_Allreduce(MPI_IN_PLACE, max, DEM_PLACED_SPHERE_LEVELS, MPI_DOUBLE, MPI_MAX,
                                  s->decomposition.comm));
    }
    for (int k = 0; k < DEM_PLACED_SPHERE_LEVELS && s->decomposition.ranks > 1; k++)
    {
        s->level[k].max_radius = max[k];
    }
    *mean = sum/(double)(p->diameters ? p->n : 1);
    return DEM_OK;
}

/* Spheres of earlier groups go to the ranks that own their positions, and as ghosts to others
   within reach. */
static int collect_fixed(const struct dem_packing *p, const struct dem_initial_particles *c,
                         struct dem_placed_spheres *s)
{
    enum { OWNED, GHOST };

    s->messages = 0;
    for (size_t k = 0; k < c->n; k++)
    {
        struct dem_placed_sphere sphere = {.radius = c->particle[k].radius, .number = -1};
        int sent;

        if (reaches_into(p->shape, &c->particle[k]))
        {
            memcpy(sphere.x, c->particle[k].x, sizeof sphere.x);
            DEM_TRY(
                dem_placed_spheres_send_ghosts(s, &sphere, GHOST, sphere.radius + s->max_radius));
            DEM_TRY(dem_placed_spheres_send_to_owner(s, &sphere, OWNED, &sent));
            sphere.v[0] = 1.0;
            DEM_TRY(sent ? DEM_OK : dem_placed_spheres_add(s, &sphere));
        }
    }
    DEM_TRY(dem_placed_spheres_exchange(s));
    for (size_t k = 0; k < s->messages; k++)
    {
        s->message[k].sphere.v[0] = s->message[k].kind == OWNED;
        DEM_TRY(dem_placed_spheres_add(s, &s->message[k].sphere));
    }
    s->messages = 0;
    return DEM_OK;
}

/* Decompose the shape by the positions that the spheres are tried at first. */
static int decompose(const struct dem_packing *p, struct dem_placed_spheres *s)
{
    const int64_t ranks = s->decomposition.ranks, from = p->n*s->decomposition.rank/ranks;
    const int64_t to = p->n*(s->decomposition.rank + 1)/ranks;
    struct dem_placed_sphere *first;

    if (ranks == 1)
    {
        return dem_placed_spheres_decompose(s, 0, NULL, p->shape->min, p->shape->max);
    }
    DEM_TRY(DEM_NEW(first, to - from + 1));
    for (int64_t m = from; m < to; m++)
    {
        first[m - from] = (struct dem_placed_sphere){.radius = 0.5*diameter_of(p, m), .number = m};
        (void)dem_packing_draw(p, &first[m - from], 0);
    }
    const int status =
        dem_placed_spheres_decompose(s, (size_t)(to - from), first, p->shape->min, p->shape->max);

    dem_memory_free(first);
    return status;
}

/* Failures within the limits are noted on the way, so that the ranks stay in step. */
static int limits_status(const struct dem_packing *p, const struct dem_placed_spheres *s)
{
    return p->shape->limits ? dem_collect_agree(&s->decomposition, p->shape->limits->status)
                            : DEM_OK;
}

int dem_packing_fill(const struct dem_packing *p, const struct dem_initial_particles *c,
                     struct dem_placed_spheres *s)
{
    int64_t left;
    double mean_diameter;

    DEM_TRY(find_sizes(p, c, s, &mean_diameter));
    DEM_TRY(decompose(p, s));
    DEM_TRY(collect_fixed(p, c, s));
    DEM_TRY(dem_packing_place(p, s, &left));
    DEM_TRY(limits_status(p, s));
    DEM_TRY(left > 0 ? dem_packing_relax(p, s, mean_diameter) : DEM_OK);
    return limits_status(p, s);
}
