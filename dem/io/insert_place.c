/*
 * insert_place.c -- three ways to fill a region: on a lattice with jitter, at random (packing.h), one by one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/insert_batch.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/random.h"
#include "io/packing.h"
#include <math.h>
#include <string.h>

enum
{
    USE_JITTER = 101                                      /* stream of random numbers */
};

static struct dem_particle sphere(const struct dem_batch *b, const struct dem_recipe *r, const double x[3], int64_t number)
{
    const double diameter = b->diameters ? b->diameters[number] : b->diameter;
    struct dem_particle p = dem_particle_sphere(-1, x, diameter, r->material[b->material].density, b->material);

    memcpy(p.v, b->velocities ? b->velocities[number] : b->velocity, sizeof p.v);
    memcpy(p.w, b->spins ? b->spins[number] : b->spin, sizeof p.w);
    if (b->frozen)
    {
        p.flags |= DEM_PARTICLE_FROZEN;
        p.inverse_mass = p.inverse_inertia = 0.0;
    }
    return p;
}

void dem_batch_site(const struct dem_batch *b, int64_t m, double x[3])
{
    const int64_t *const n = b->sites, at[3] = {m%n[0], m/n[0]%n[1], m/(n[0]*n[1])};
    const struct dem_vessel *const v = &b->vessel;

    for (int k = 0; k < 3; k++)
    {
        const double wide = (v->max[k] - v->min[k])/(double)n[k], pitch = k == 2 && wide > b->pitch ? b->pitch : wide;
        const double shake = dem_random_unit((uint64_t)b->seed, (uint64_t)m, 0, USE_JITTER + (uint64_t)k) - 0.5;

        x[k] = v->min[k] + ((double)at[k] + 0.5)*pitch + fmin(b->amplitude, wide - b->diameter)*shake;
    }
}

static int place_lattice(struct dem_crowd *c, const struct dem_batch *b, const struct dem_recipe *r)
{
    for (int64_t m = 0; m < b->count; m++)
    {
        double x[3];

        dem_batch_site(b, m, x);
        DEM_TRY(dem_crowd_add(c, sphere(b, r, x, m), b->where));
    }
    return DEM_OK;
}

static int place_random(struct dem_crowd *c, const struct dem_batch *b, const struct dem_recipe *r)
{
    struct dem_packing p = {.vessel = &b->vessel, .where = b->where, .seed = (uint64_t)b->seed, .n = (int32_t)b->count,
                            .diameter = b->diameters};

    DEM_TRY(DEM_NEW(p.x, p.n + 1));
    int status = dem_packing_fill(&p, c);

    for (int32_t m = 0; m < p.n && !status; m++)
    {
        status = dem_crowd_add(c, sphere(b, r, p.x[m], m), p.where);
    }
    dem_memory_free(p.x);
    return status;
}

static int place_list(struct dem_crowd *c, const struct dem_batch *b, const struct dem_recipe *r)
{
    for (int64_t m = 0; m < b->count; m++)
    {
        DEM_TRY(dem_crowd_add(c, sphere(b, r, b->positions[m], m), b->where));
    }
    return DEM_OK;
}

int dem_batch_place(struct dem_crowd *c, const struct dem_batch *b, const struct dem_recipe *r)
{
    switch (b->type)
    {
    case DEM_BATCH_LATTICE: return place_lattice(c, b, r);
    case DEM_BATCH_RANDOM: return place_random(c, b, r);
    default: return place_list(c, b, r);
    }
}
