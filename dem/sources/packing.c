/*
 * packing.c -- place spheres at random without overlap, up to a solid fraction of 0.57.
 *
 * 1. Decompose the shape among ranks; collect the spheres of earlier groups that reach into it.
 * 2. Random sequential addition, largest spheres first (packing_addition.c).
 * 3. Remove the remaining overlaps by pairwise relaxation (packing_relax.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/packing.h"
#include "core/error.h"
#include "core/memory.h"
#include "ranks/collect.h"
#include <math.h>
#include <string.h>

/* 0.58 takes three times as long as 0.55; random close packing is 0.64 */
static const double max_fraction = 0.57;

int dem_packing_check_fraction(const struct dem_insertion_shape *v, double volume, double n,
                               const char *of, const char *where)
{
    const double room = dem_insertion_shape_volume(v), fraction = volume/room;

    /* a number of particles meets a solid fraction to one particle */
    DEM_REQUIRE(volume - volume/fmax(n, 1.0) <= max_fraction*room, DEM_ERROR_INPUT,
                "%s: %.10g %s at random are a solid fraction of %.6g, the limit is %g; "
                "enlarge the region, ask for fewer, use type lattice, or let a looser packing "
                "settle", where, n, of, fraction, max_fraction);
    return DEM_OK;
}

/* ---- set-up ---------------------------------------------------------------------------------- */

static double diameter_of(const struct dem_packing *p, int64_t m)
{
    return p->diameters ? p->diameters[m] : p->diameter;
}

/* Does a particle, or an image of it, reach into the shape, or at open sides as far as the spheres
   there, of this radius [m] at most? */
static int reaches_into(const struct dem_insertion_shape *v, const struct dem_particle *q,
                        double largest)
{
    int reaches = 1;

    for (int k = 0; k < 3; k++)
    {
        const double reach = q->radius + (v->period[k] > 0.0 ? largest : 0.0);
        const double low = v->min[k] - reach, high = v->max[k] + reach, period = v->period[k];
        const double x = period > 0.0 ? q->x[k] + period*ceil((low - q->x[k])/period) : q->x[k];

        reaches &= x > low && x < high;
    }
    return reaches;
}

/* The particles of earlier groups that reach into the shape, frozen. */
static int collect_fixed(const struct dem_packing *p, const struct dem_initial_particles *c,
                         struct dem_packing_spheres *s)
{
    double largest = 0.5*p->diameter;

    for (int64_t m = 0; p->diameters && m < p->n; m++)
    {
        largest = fmax(largest, 0.5*p->diameters[m]);
    }
    for (size_t k = 0; k < c->n; k++)
    {
        if (reaches_into(p->shape, &c->particle[k], largest))
        {
            struct dem_particle fixed = {.radius = c->particle[k].radius,
                                         .id = -1 - c->particle[k].id,
                                         .flags = DEM_PARTICLE_FROZEN};

            memcpy(fixed.x, c->particle[k].x, sizeof fixed.x);
            s->max_radius = fmax(s->max_radius, fixed.radius);
            DEM_TRY(dem_particles_add(&s->particles, &fixed));
        }
    }
    return DEM_OK;
}

/* The largest radius of all; *mean is the mean diameter of the new spheres, which are known on all
   ranks. */
static void find_sizes(const struct dem_packing *p, struct dem_packing_spheres *s, double *mean)
{
    const int64_t sizes = p->diameters ? p->n : 1;
    double sum = 0.0;

    for (int64_t m = 0; m < sizes; m++)
    {
        s->max_radius = fmax(s->max_radius, 0.5*diameter_of(p, m));
        sum += diameter_of(p, m);
    }
    dem_collect_max_double(&s->decomposition, &s->max_radius, 1);
    *mean = sum/(double)sizes;
}

/* Decompose space by the positions that the spheres are tried at first. */
static int decompose(const struct dem_packing *p, struct dem_packing_spheres *s)
{
    const int64_t ranks = s->decomposition.ranks, from = p->n*s->decomposition.rank/ranks;
    const int64_t to = p->n*(s->decomposition.rank + 1)/ranks;
    struct dem_particle *first = NULL;

    if (ranks == 1)
    {
        return DEM_OK;
    }
    int status = dem_collect_agree(&s->decomposition, DEM_NEW(first, to - from + 1));

    for (int64_t m = from; m < to && !status; m++)
    {
        first[m - from] = (struct dem_particle){.radius = 0.5*diameter_of(p, m), .id = m};
        (void)dem_packing_draw(p, &first[m - from], 0);
    }
    status = status ? status
                    : dem_decomposition_divide(&s->decomposition, (size_t)(to - from), first->x,
                                               sizeof *first/sizeof(double));
    dem_memory_free(first);
    return status;
}

int dem_packing_fill(const struct dem_packing *p, const struct dem_initial_particles *c,
                     struct dem_packing_spheres *s)
{
    int64_t left;
    double mean_diameter;

    DEM_TRY(dem_collect_agree(&s->decomposition, collect_fixed(p, c, s)));
    find_sizes(p, s, &mean_diameter);
    DEM_TRY(decompose(p, s));
    DEM_TRY(dem_packing_place(p, s, &left));
    return left > 0 ? dem_packing_relax(p, s, mean_diameter) : DEM_OK;
}
