/*
 * insert.c -- three ways to fill a region.
 *
 *     bed { type lattice; material glass; diameter 1e-3; count 1000; min (0 0 0); max (0.01 0.01 0.05);
 *           spacing 1.1; jitter 0.5; seed 1; velocity (0 0 0); }
 *
 * lattice   simple cubic in a box, spacing in diameters, filled from the bottom layer up; jitter is the share of the free gap
 * random    random places in a box, cylinder or sphere, clear of the groups before (packing.h), sizes drawn (sizes.h)
 * list      positions ((x y z) ...), with one diameter or as many
 *
 * How many: count, mass [kg] or solidFraction of the region. With the last two particles are drawn until the sum is
 * nearest to what is asked for: within half of the last one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/insert.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/random.h"
#include "base/unknown.h"
#include "io/packing.h"
#include "io/scene_parts.h"
#include "io/sizes.h"
#include "io/vessel.h"
#include <math.h>
#include <string.h>

enum
{
    USE_JITTER = 101,                                     /* stream of random numbers */
    MOST_PARTICLES = 1000000000                           /* of one group */
};

struct group
{
    const struct dem_dict *dict;
    int material;
    double diameter, min[3], max[3], velocity[3], spin[3];
    int64_t count, seed;
    bool frozen;
};

static int add(struct dem_crowd *c, const struct group *g, const struct dem_recipe *r, const double x[3], double diameter)
{
    struct dem_particle p = dem_particle_sphere(-1, x, diameter, r->material[g->material].density, g->material);

    memcpy(p.v, g->velocity, sizeof p.v);
    memcpy(p.w, g->spin, sizeof p.w);
    if (g->frozen)
    {
        p.flags |= DEM_PARTICLE_FROZEN;
        p.inverse_mass = p.inverse_inertia = 0.0;
    }
    return dem_crowd_add(c, p, dem_dict_where(g->dict));
}

/* ---- how many ------------------------------------------------------------------------------------------------ */

struct amount
{
    int64_t count;                                        /* 0: until the volume is reached */
    double volume;                                        /* m3 */
};

static int read_amount(struct amount *a, const struct group *g, const struct dem_recipe *r, const struct dem_vessel *v)
{
    const struct dem_dict *const d = g->dict;
    const int ways = dem_dict_has(d, "count") + dem_dict_has(d, "mass") + dem_dict_has(d, "solidFraction");
    double value;

    DEM_REQUIRE(ways == 1, DEM_ERROR_INPUT, "%s: %s of count, mass, solidFraction; give one of them", dem_dict_where(d),
                ways ? "more than one" : "none");
    *a = (struct amount){.count = 0};
    if (dem_dict_has(d, "count"))
    {
        DEM_TRY(dem_dict_int64(d, "count", &a->count));
        DEM_REQUIRE(a->count > 0 && a->count <= MOST_PARTICLES, DEM_ERROR_INPUT, "%s: count %lld; give 1 to %d", dem_dict_where(d),
                    (long long)a->count, MOST_PARTICLES);
        return DEM_OK;
    }
    if (dem_dict_has(d, "mass"))
    {
        DEM_TRY(dem_dict_number(d, "mass", "kg", &value));
        DEM_REQUIRE(value > 0.0, DEM_ERROR_INPUT, "%s: mass %g kg; give a number above 0", dem_dict_where(d), value);
        a->volume = value/r->material[g->material].density;
        return DEM_OK;
    }
    DEM_TRY(dem_dict_number(d, "solidFraction", "1", &value));
    DEM_REQUIRE(value > 0.0 && value < 0.74, DEM_ERROR_INPUT, "%s: solidFraction %g; give a number above 0 and below 0.74",
                dem_dict_where(d), value);
    a->volume = value*dem_vessel_volume(v);
    return DEM_OK;
}

/* Draw diameters until there are enough. */
static int draw(const struct group *g, const struct amount *a, const struct dem_sizes *sizes, double **diameter, int64_t *n)
{
    double volume = 0.0, last = 0.0;
    size_t room = 0;

    *diameter = NULL;
    for (*n = 0; a->count > 0 ? *n < a->count : volume < a->volume; (*n)++)
    {
        DEM_REQUIRE(*n < MOST_PARTICLES, DEM_ERROR_INPUT, "%s: more than %d particles; ask for fewer", dem_dict_where(g->dict), MOST_PARTICLES);
        DEM_TRY(DEM_GROW(*diameter, room, *n + 1));
        const double d = (*diameter)[*n] = dem_sizes_draw(sizes, (uint64_t)g->seed, (uint64_t)*n);

        last = 3.14159265358979323846/6.0*d*d*d;
        volume += last;
    }
    *n -= a->count == 0 && *n > 0 && volume - a->volume > 0.5*last;
    DEM_REQUIRE(*n > 0, DEM_ERROR_INPUT, "%s: less than half a particle; ask for more", dem_dict_where(g->dict));
    return DEM_OK;
}

/* ---- on a lattice -------------------------------------------------------------------------------------------- */

static int read_box(struct group *g, const struct dem_recipe *r)
{
    struct dem_vessel v;
    struct dem_sizes sizes;
    struct amount amount;
    double *diameter;

    DEM_REQUIRE(!dem_dict_has(g->dict, "sizes") && !dem_dict_has(g->dict, "cylinder") && !dem_dict_has(g->dict, "sphere"), DEM_ERROR_INPUT,
                "%s: a lattice has one diameter and fills a box; use type random, or diameter, min and max", dem_dict_where(g->dict));
    DEM_TRY(dem_sizes_read(&sizes, g->dict));
    DEM_TRY(dem_vessel_read(&v, g->dict));
    DEM_TRY(read_amount(&amount, g, r, &v));
    DEM_TRY(dem_dict_int64_or(g->dict, "seed", 1, &g->seed));
    DEM_TRY(dem_vessel_holds(&v, 0.5*sizes.least, dem_dict_where(g->dict)));
    g->diameter = sizes.least;
    memcpy(g->min, v.min, sizeof g->min);
    memcpy(g->max, v.max, sizeof g->max);
    const int status = draw(g, &amount, &sizes, &diameter, &g->count);

    dem_memory_free(diameter);
    return status;
}

static int insert_lattice(struct dem_crowd *c, struct group *g, const struct dem_recipe *r)
{
    double spacing, jitter, cells = 1.0;
    int64_t n[3];

    DEM_TRY(read_box(g, r));
    DEM_TRY(dem_dict_number_or(g->dict, "spacing", "1", 1.1, &spacing));
    DEM_TRY(dem_dict_number_or(g->dict, "jitter", "1", 0.5, &jitter));
    DEM_REQUIRE(spacing >= 1.0 && jitter >= 0.0 && jitter <= 1.0, DEM_ERROR_INPUT,
                "%s: spacing %g, jitter %g; give a spacing of 1 diameter or more and a jitter in 0 .. 1",
                dem_dict_where(g->dict), spacing, jitter);
    const double pitch = spacing*g->diameter, amplitude = jitter*(pitch - g->diameter);

    for (int k = 0; k < 3; k++)
    {
        n[k] = (int64_t)((g->max[k] - g->min[k])/pitch*(1.0 + 1e-12));
        n[k] = n[k] < 1 ? 1 : n[k];
        cells *= (double)n[k];
    }
    DEM_REQUIRE((double)g->count <= cells, DEM_ERROR_INPUT,
                "%s: count %lld, but the box holds %.0f (%lld x %lld x %lld) at a spacing of %g diameters; enlarge the box "
                "or ask for fewer", dem_dict_where(g->dict), (long long)g->count, cells, (long long)n[0], (long long)n[1],
                (long long)n[2], spacing);
    for (int64_t m = 0; m < g->count; m++)
    {
        const int64_t at[3] = {m%n[0], m/n[0]%n[1], m/(n[0]*n[1])};
        double x[3];

        for (int k = 0; k < 3; k++)
        {
            const double wide = (g->max[k] - g->min[k])/(double)n[k], pitch_here = k == 2 && wide > pitch ? pitch : wide;
            const double shake = dem_random_unit((uint64_t)g->seed, (uint64_t)m, 0, USE_JITTER + (uint64_t)k) - 0.5;

            x[k] = g->min[k] + ((double)at[k] + 0.5)*pitch_here + fmin(amplitude, wide - g->diameter)*shake;
        }
        DEM_TRY(add(c, g, r, x, g->diameter));
    }
    return DEM_OK;
}

/* ---- at random ----------------------------------------------------------------------------------------------- */

static int pack(struct dem_crowd *c, struct group *g, const struct dem_recipe *r, const struct dem_vessel *v, const double *diameter)
{
    struct dem_packing p = {.vessel = v, .where = dem_dict_where(g->dict), .seed = (uint64_t)g->seed, .n = (int32_t)g->count,
                            .diameter = diameter};

    DEM_TRY(DEM_NEW(p.x, p.n + 1));
    int status = dem_packing_fill(&p, c);

    for (int32_t m = 0; m < p.n && !status; m++)
    {
        status = add(c, g, r, p.x[m], diameter[m]);
    }
    dem_memory_free(p.x);
    return status;
}

static int insert_random(struct dem_crowd *c, struct group *g, const struct dem_recipe *r)
{
    struct dem_vessel v;
    struct dem_sizes sizes;
    struct amount amount;
    double *diameter = NULL;

    DEM_TRY(dem_vessel_read(&v, g->dict));
    DEM_TRY(read_amount(&amount, g, r, &v));
    DEM_TRY(dem_dict_int64_or(g->dict, "seed", 1, &g->seed));
    int status = dem_sizes_read(&sizes, g->dict);

    status = status ? status : draw(g, &amount, &sizes, &diameter, &g->count);
    status = status ? status : pack(c, g, r, &v, diameter);
    dem_sizes_free(&sizes);
    dem_memory_free(diameter);
    return status;
}

/* ---- one by one ---------------------------------------------------------------------------------------------- */

static int insert_list(struct dem_crowd *c, struct group *g, const struct dem_recipe *r)
{
    const double (*position)[3], (*velocity)[3] = NULL, (*spin)[3] = NULL, *diameter = NULL;
    size_t n, velocities = 0, spins = 0, diameters = 0;

    DEM_TRY(dem_dict_vectors(g->dict, "positions", "m", &position, &n));
    if (!dem_dict_has(g->dict, "diameters"))
    {
        DEM_TRY(dem_dict_number(g->dict, "diameter", "m", &g->diameter));
        DEM_REQUIRE(g->diameter > 0.0, DEM_ERROR_INPUT, "%s: diameter %g m; give a number above 0", dem_dict_where(g->dict), g->diameter);
    }
    if (dem_dict_has(g->dict, "velocities"))
    {
        DEM_TRY(dem_dict_vectors(g->dict, "velocities", "m/s", &velocity, &velocities));
    }
    if (dem_dict_has(g->dict, "spins"))
    {
        DEM_TRY(dem_dict_vectors(g->dict, "spins", "1/s", &spin, &spins));
    }
    if (dem_dict_has(g->dict, "diameters"))
    {
        DEM_TRY(dem_dict_numbers(g->dict, "diameters", "m", &diameter, &diameters));
    }
    DEM_REQUIRE((!velocity || velocities == n) && (!spin || spins == n) && (!diameter || diameters == n), DEM_ERROR_INPUT,
                "%s: %zu positions, but %zu velocities, %zu spins, %zu diameters; give as many of each, or leave the list out",
                dem_dict_where(g->dict), n, velocities, spins, diameters);
    for (size_t m = 0; m < n; m++)
    {
        if (velocity)
        {
            memcpy(g->velocity, velocity[m], sizeof g->velocity);
        }
        if (spin)
        {
            memcpy(g->spin, spin[m], sizeof g->spin);
        }
        DEM_TRY(add(c, g, r, position[m], diameter ? diameter[m] : g->diameter));
    }
    return DEM_OK;
}

/* ---- reading ------------------------------------------------------------------------------------------------- */

static int read_group(struct dem_crowd *c, const struct dem_dict *dict, const struct dem_recipe *r)
{
    static const char *const known[] = {"lattice", "random", "list"};
    static const double zero[3] = {0.0, 0.0, 0.0};
    struct group g = {.dict = dict};
    const char *type;

    DEM_TRY(dem_dict_word(dict, "type", &type));
    DEM_TRY(dem_scene_read_material_of(dict, r, &g.material));
    DEM_TRY(dem_dict_vector_or(dict, "velocity", "m/s", zero, g.velocity));
    DEM_TRY(dem_dict_vector_or(dict, "spin", "1/s", zero, g.spin));
    DEM_TRY(dem_dict_switch_or(dict, "frozen", false, &g.frozen));
    if (strcmp(type, known[0]) == 0)
    {
        return insert_lattice(c, &g, r);
    }
    if (strcmp(type, known[1]) == 0)
    {
        return insert_random(c, &g, r);
    }
    if (strcmp(type, known[2]) == 0)
    {
        return insert_list(c, &g, r);
    }
    return dem_error_prefix(dem_unknown_word("type of insertion", type, known, 3), "%s: ", dem_dict_where(dict));
}

int dem_insert_read(struct dem_crowd *c, const struct dem_dict *insert, const struct dem_recipe *r)
{
    for (size_t k = 0; k < dem_dict_count(insert); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(insert, k);

        DEM_REQUIRE(dem_entry_is_dict(e), DEM_ERROR_INPUT, "%s: insert holds groups like %s { type lattice; ... }",
                    dem_entry_where(e), dem_entry_name(e));
        DEM_TRY(dem_crowd_begin(c, dem_entry_name(e)));
        DEM_TRY(read_group(c, dem_entry_dict(e), r));
    }
    return DEM_OK;
}
