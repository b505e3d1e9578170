/*
 * insert_place.c -- three ways to fill a region: on a lattice with jitter, at random (packing.h), one by one from a list or table; each rank a share.
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
    const double diameter = dem_batch_diameter(b, number);
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

/* Those of this rank's share of a list or a lattice. */
static int place_share(struct dem_crowd *c, const struct dem_batch *b, const struct dem_recipe *r, const struct dem_pieces *q)
{
    const int64_t first = c->next_id, from = b->count*q->rank/q->ranks, to = b->count*(q->rank + 1)/q->ranks;

    for (int64_t m = from; m < to; m++)
    {
        struct dem_particle p;
        double x[3];

        if (b->type == DEM_BATCH_LATTICE)
        {
            dem_batch_site(b, m, x);
        }
        p = sphere(b, r, b->type == DEM_BATCH_LATTICE ? x : b->positions[m], m);
        p.id = b->ids ? b->ids[m] : first + m;
        DEM_TRY(dem_crowd_add(c, p, b->where));
    }
    return DEM_OK;
}

static int place_random(struct dem_crowd *c, const struct dem_batch *b, const struct dem_recipe *r, const struct dem_pieces *q)
{
    const struct dem_packing p = {.vessel = &b->vessel, .where = b->where, .seed = (uint64_t)b->seed, .n = b->count,
                                  .diameter = b->diameter, .diameters = b->diameters};
    const int64_t first = c->next_id;
    struct dem_spots s;
    int status = dem_spots_init(&s, q);

    status = status ? status : dem_packing_fill(&p, c, &s);
    for (size_t k = 0; k < s.n && !status; k++)
    {
        if (s.spot[k].name >= 0)
        {
            struct dem_particle new = sphere(b, r, s.spot[k].x, s.spot[k].name);

            new.id = first + s.spot[k].name;
            status = dem_crowd_add(c, new, p.where);
        }
    }
    dem_spots_free(&s);
    return status;
}

int dem_batch_place(struct dem_crowd *c, const struct dem_batch *b, const struct dem_recipe *r, const struct dem_pieces *q)
{
    return b->type == DEM_BATCH_RANDOM ? place_random(c, b, r, q) : place_share(c, b, r, q);
}

/* All that is known of a group is known to every rank. */
static int count_batch(struct dem_crowd *c, const struct dem_batch *b, const struct dem_recipe *r)
{
    const double density = r->material[b->material].density;

    DEM_TRY(dem_crowd_begin(c, dem_dict_name(b->dict)));
    for (int64_t m = 0; m < (b->diameters ? b->count : 1); m++)
    {
        const double d = dem_batch_diameter(b, m);

        dem_crowd_count(c, b->diameters ? 1 : b->count, d, density*dem_sphere_volume(0.5*d), b->material);
    }
    return DEM_OK;
}

/* All ranks fail when one does: what comes next needs them all. */
static int together(const struct dem_pieces *q, int status)
{
    int worst = status;

    if (q->ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_INT, MPI_MAX, q->comm);
    }
    return worst == DEM_OK || status != DEM_OK ? status : dem_error(worst, "another rank failed; its message tells why");
}

int dem_insert_place(struct dem_crowd *c, const struct dem_insertion *i, const struct dem_recipe *r, const struct dem_pieces *q)
{
    for (size_t k = 0; k < i->n; k++)
    {
        const struct dem_batch *const b = &i->batch[k];
        const int64_t first = c->next_id;
        /* all at once, so that too many fail now */
        int status = count_batch(c, b, r);

        status = status ? status : DEM_GROW(c->particle, c->room, c->n + (size_t)(b->count/q->ranks));
        status = together(q, status ? dem_error_prefix(status, "%s: %lld particles: ", b->where, (long long)b->count) : DEM_OK);
        DEM_TRY(status ? status : together(q, dem_batch_place(c, b, r, q)));
        c->next_id = dem_batch_next_id(b, first);
    }
    return DEM_OK;
}
