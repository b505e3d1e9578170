/*
 * insert_place.c -- create the particles of a group: on a lattice with jitter, at random
 * (packing.h), or from a list or table.
 *
 * A lattice, list or table is cut into equal runs of particle numbers, one a rank.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/insert_group.h"
#include "core/error.h"
#include "core/memory.h"
#include "sources/packing.h"
#include "particles/scalars.h"
#include "ranks/collect.h"
#include <math.h>
#include <string.h>

static struct dem_particle make_particle(const struct dem_insert_group *b,
                                         const struct dem_interaction_table *r, const double x[3],
                                         int64_t number)
{
    const double diameter = dem_insert_group_diameter(b, number);
    struct dem_particle p =
        dem_particle_sphere(-1, x, diameter, r->material[b->material].density, b->material);

    memcpy(p.v, b->velocities ? b->velocities[number] : b->velocity, sizeof p.v);
    memcpy(p.w, b->spins ? b->spins[number] : b->spin, sizeof p.w);
    if (b->frozen || b->driven)
    {
        p.flags |= b->driven ? DEM_PARTICLE_FROZEN | DEM_PARTICLE_DRIVEN : DEM_PARTICLE_FROZEN;
        p.inverse_mass = p.inverse_inertia = 0.0;
    }
    return p;
}

/* The scalars of the particle added last: of particle or body `number`. */
static void set_scalars(struct dem_initial_particles *c, const struct dem_insert_group *b, int64_t number)
{
    for (int k = 0; k < c->scalars; k++)
    {
        dem_initial_particles_last_scalars(c)[k] =
            b->scalars[k] ? b->scalars[k][number]
                          : dem_scalar_draw(&b->scalar[k], k, (uint64_t)b->seed, (uint64_t)number);
    }
}

/* Add the spheres of a body. */
static int add_clump(struct dem_initial_particles *c, const struct dem_insert_group *b,
                     double density, const struct dem_particle *p, int64_t number)
{
    struct dem_clump body;

    dem_clump_source_make(&b->clump, (uint64_t)b->seed, number, density, p, &body);
    for (size_t k = 0; k < b->clump.shape->n; k++)
    {
        DEM_TRY(dem_initial_particles_add(
            c, dem_clump_source_sphere(&b->clump, density, p, k, &body), b->where));
        c->clump[c->n - 1] = body;
        set_scalars(c, b, number);
    }
    return DEM_OK;
}

/* Add particle `number` of the group, with its scalars. */
static int add_particle(struct dem_initial_particles *c, const struct dem_insert_group *b,
                        const struct dem_interaction_table *r, const struct dem_particle *p,
                        int64_t number)
{
    if (b->clump.shape)
    {
        return add_clump(c, b, r->material[b->material].density, p, number);
    }
    DEM_TRY(dem_initial_particles_add(c, *p, b->where));
    set_scalars(c, b, number);
    return DEM_OK;
}

/* ---- lattice with limits --------------------------------------------------------------------- */

/* The sites of this rank's run where a sphere may lie. */
static int find_sites(struct dem_insert_group *b, const struct dem_decomposition *q)
{
    const int64_t sites = b->sites[0]*b->sites[1]*b->sites[2];
    const int64_t from = sites*q->rank/q->ranks, to = sites*(q->rank + 1)/q->ranks;
    size_t capacity = 0;

    for (int64_t m = from; m < to; m++)
    {
        double x[3];

        dem_insert_group_site(b, m, x);
        if (dem_insertion_limits_allow(b->limits, 0.5*b->diameter, x))
        {
            DEM_TRY(DEM_GROW(b->site, capacity, (size_t)b->site_count + 1));
            b->site[b->site_count++] = m;
        }
        DEM_TRY(b->limits->status);
    }
    return DEM_OK;
}

/* Take the first `count` sites that are free, or all of them. */
static int take_sites(struct dem_insert_group *b, const struct dem_decomposition *q)
{
    int64_t total;

    DEM_TRY(dem_collect_agree(q, find_sites(b, q)));
    total = b->site_count;
    dem_collect_sum_int64(q, &total, 1);
    dem_collect_sum_before(q, &b->site_count, &b->site_first, 1);
    DEM_TRY(dem_collect_status(q));
    DEM_REQUIRE(total > 0 && (b->fill || total >= b->count), DEM_ERROR_INPUT,
                "%s: count %lld, but %lld positions of the lattice lie inside, off the walls; "
                "enlarge the region or ask for fewer",
                b->where, (long long)(b->fill ? 1 : b->count), (long long)total);
    b->count = b->fill ? total : b->count;
    const int64_t left = b->count - b->site_first;

    b->site_count = left < 0 ? 0 : left < b->site_count ? left : b->site_count;
    return DEM_OK;
}

static int place_sites(struct dem_initial_particles *c, const struct dem_insert_group *b,
                       const struct dem_interaction_table *r)
{
    const int64_t ids = dem_clump_source_ids(&b->clump), first = c->next_id + b->site_first*ids;

    for (int64_t k = 0; k < b->site_count; k++)
    {
        struct dem_particle p;
        double x[3];

        dem_insert_group_site(b, b->site[k], x);
        p = make_particle(b, r, x, b->site_first + k);
        p.id = first + k*ids;
        DEM_TRY(add_particle(c, b, r, &p, b->site_first + k));
    }
    return DEM_OK;
}

/* Collective. With limits: the search for walls, and the sites of a lattice. */
static int prepare_limits(struct dem_insert_group *b, const struct dem_walls *w,
                          const struct dem_domain *d, const struct dem_decomposition *q)
{
    double radius = 0.0;

    if (!b->limits)
    {
        return DEM_OK;
    }
    for (int64_t m = 0; m < (b->diameters ? b->count : 1); m++)
    {
        radius = fmax(radius, 0.5*dem_insert_group_diameter(b, m));
    }
    DEM_TRY(dem_collect_agree(q, dem_insertion_limits_prepare(b->limits, w, d, radius)));
    return b->type == DEM_INSERT_LATTICE ? take_sites(b, q) : DEM_OK;
}

/* ---- all types ------------------------------------------------------------------------------- */

/* This rank's run of a lattice, list or table. */
static int place_run(struct dem_initial_particles *c, const struct dem_insert_group *b,
                     const struct dem_interaction_table *r, const struct dem_decomposition *q)
{
    const int64_t first = c->next_id, from = b->count*q->rank/q->ranks;
    const int64_t to = b->count*(q->rank + 1)/q->ranks;

    for (int64_t m = from; m < to; m++)
    {
        struct dem_particle p;
        double x[3];

        if (b->type == DEM_INSERT_LATTICE)
        {
            dem_insert_group_site(b, m, x);
        }
        p = make_particle(b, r, b->type == DEM_INSERT_LATTICE ? x : b->positions[m], m);
        p.id = b->ids ? b->ids[m] : first + m*dem_clump_source_ids(&b->clump);
        DEM_TRY(add_particle(c, b, r, &p, m));
    }
    return DEM_OK;
}

static int place_random(struct dem_initial_particles *c, const struct dem_insert_group *b,
                        const struct dem_interaction_table *r, const struct dem_domain *d,
                        const struct dem_decomposition *q)
{
    const struct dem_packing p = {.shape = &b->shape,
                                  .domain = d,
                                  .where = b->where,
                                  .seed = (uint64_t)b->seed,
                                  .n = b->count,
                                  .diameter = b->diameter,
                                  .diameters = b->diameters};
    const int64_t first = c->next_id;
    struct dem_packing_spheres s;
    int status = dem_collect_agree(q, dem_packing_spheres_init(&s, d, q));

    status = status ? status : dem_packing_fill(&p, c, &s);
    for (size_t k = 0; k < s.particles.n && !status; k++)
    {
        const struct dem_particle *const sphere = &s.particles.record[k];

        if (sphere->id >= 0)    /* not of an earlier group */
        {
            struct dem_particle new = make_particle(b, r, sphere->x, sphere->id);

            new.id = first + sphere->id*dem_clump_source_ids(&b->clump);
            status = add_particle(c, b, r, &new, sphere->id);
        }
    }
    dem_packing_spheres_free(&s);
    return status;
}

int dem_insert_group_place(struct dem_initial_particles *c, const struct dem_insert_group *b,
                           const struct dem_interaction_table *r, const struct dem_domain *d,
                           const struct dem_decomposition *q)
{
    return b->type == DEM_INSERT_RANDOM ? place_random(c, b, r, d, q)
         : b->limits ? place_sites(c, b, r)
                                           : place_run(c, b, r, q);
}

/* The summary of a group, of the particles of all ranks. */
static int summarize(struct dem_initial_particles *c, const struct dem_insert_group *b,
                     const struct dem_interaction_table *r)
{
    const double density = r->material[b->material].density;

    DEM_TRY(dem_initial_particles_begin_group(c, dem_dict_name(b->dict)));
    for (int64_t m = 0; b->clump.shape && m < dem_clump_source_ids(&b->clump); m++)
    {
        const double d = 2.0*b->clump.shape->sphere[m][3];
        const double volume = b->clump.shape->volume*b->clump.shape->share[m];

        dem_initial_particles_count(c, b->count, d, volume, density*volume, b->material);
    }
    for (int64_t m = 0; !b->clump.shape && m < (b->diameters ? b->count : 1); m++)
    {
        const double d = dem_insert_group_diameter(b, m), volume = dem_sphere_volume(0.5*d);

        dem_initial_particles_count(c, b->diameters ? 1 : b->count, d, volume, density*volume,
                                    b->material);
    }
    return DEM_OK;
}

int dem_insert_place(struct dem_initial_particles *c, struct dem_insertion *i,
                     const struct dem_interaction_table *r, const struct dem_walls *w,
                     const struct dem_decomposition *q)
{
    dem_initial_particles_have_scalars(c, r);
    c->has_clumps = i->shapes && i->shapes->n > 0;
    for (size_t k = 0; k < i->n; k++)
    {
        struct dem_insert_group *const b = &i->group[k];
        const int64_t first = c->next_id;

        DEM_TRY(prepare_limits(b, w, i->domain, q));
        int status = summarize(c, b, r);

        /* memory for all of them at once, so that too many fail before any is placed */
        status = status ? status
                        : DEM_GROW(c->particle, c->capacity, c->n + (size_t)(b->count/q->ranks*dem_clump_source_ids(&b->clump)));
        status =
            dem_collect_agree(q, status ? dem_error_prefix(status, "%s: %lld particles: ", b->where,
                                                           (long long)b->count)
                                        : DEM_OK);
        DEM_TRY(status);
        DEM_TRY(dem_collect_agree(q, dem_insert_group_place(c, b, r, i->domain, q)));
        c->next_id = dem_insert_group_next_id(b, first);
    }
    return DEM_OK;
}
