/*
 * insert.c -- three ways to fill a box.
 *
 *     bed { type lattice; material glass; diameter 1e-3; count 1000; min (0 0 0); max (0.01 0.01 0.05);
 *           spacing 1.1; jitter 0.5; seed 1; velocity (0 0 0); }
 *
 * lattice   simple cubic, spacing in diameters, filled from the bottom layer up; jitter is the share of the free gap
 * random    random sequential addition: a trial that overlaps is drawn anew; jams near a solid fraction of 0.38
 * list      positions ((x y z) ...), with one diameter or as many
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/insert.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/random.h"
#include "base/unknown.h"
#include "io/scene_parts.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum
{
    USE_JITTER = 101, USE_PLACE = 201,                    /* streams of random numbers */
    MOST_TRIALS = 2000                                    /* a particle that finds no place in so many is refused */
};

struct group
{
    const struct dem_dict *dict;
    int material;
    double diameter, min[3], max[3], velocity[3], spin[3];
    int64_t count, seed;
    bool frozen;
};

void dem_crowd_free(struct dem_crowd *c)
{
    dem_memory_free(c->particle);
    dem_memory_free(c->group);
    memset(c, 0, sizeof *c);
}

void dem_crowd_disperse(struct dem_crowd *c)
{
    dem_memory_free(c->particle);
    c->particle = NULL;
    c->n = c->room = 0;
}

int dem_crowd_begin(struct dem_crowd *c, const char *group)
{
    DEM_TRY(DEM_GROW(c->group, c->group_room, c->groups + 1));
    c->group[c->groups] = (struct dem_group){.least = INFINITY};
    snprintf(c->group[c->groups++].name, sizeof c->group->name, "%s", group);
    return DEM_OK;
}

static void count_in(struct dem_crowd *c, const struct dem_particle *p)
{
    struct dem_group *const g = &c->group[c->groups - 1];
    const double diameter = 2.0*p->radius;

    g->material = g->n == 0 || g->material == p->material ? p->material : -1;
    g->n++;
    g->least = fmin(g->least, diameter);
    g->most = fmax(g->most, diameter);
    g->sum += diameter;
    g->volume += dem_particle_volume(p);
    g->mass += p->mass;
}

int dem_crowd_add(struct dem_crowd *c, struct dem_particle p, const char *where)
{
    DEM_REQUIRE(p.radius > 0.0 && isfinite(p.radius), DEM_ERROR_INPUT, "%s: diameter %g m; give a number above 0", where,
                2.0*p.radius);
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(isfinite(p.x[k] + p.v[k] + p.w[k]), DEM_ERROR_INPUT,
                    "%s: a position, velocity or spin is not a number", where);
        DEM_REQUIRE(!(p.flags & DEM_PARTICLE_FROZEN) || (p.v[k] == 0.0 && p.w[k] == 0.0), DEM_ERROR_INPUT,
                    "%s: a frozen particle never moves, but has a velocity or spin of %g; leave it out, or frozen", where,
                    p.v[k] != 0.0 ? p.v[k] : p.w[k]);
    }
    DEM_TRY(DEM_GROW(c->particle, c->room, c->n + 1));
    p.id = p.id < 0 ? c->next_id : p.id;
    c->next_id = p.id >= c->next_id ? p.id + 1 : c->next_id;
    c->particle[c->n++] = p;
    if (c->groups > 0)
    {
        count_in(c, &p);
    }
    return DEM_OK;
}

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

static int read_box(struct group *g)
{
    DEM_TRY(dem_dict_vector(g->dict, "min", "m", g->min));
    DEM_TRY(dem_dict_vector(g->dict, "max", "m", g->max));
    DEM_TRY(dem_dict_int64(g->dict, "count", &g->count));
    DEM_TRY(dem_dict_int64_or(g->dict, "seed", 1, &g->seed));
    DEM_REQUIRE(g->count > 0, DEM_ERROR_INPUT, "%s: count %lld; give 1 or more", dem_dict_where(g->dict), (long long)g->count);
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(g->max[k] - g->min[k] >= g->diameter, DEM_ERROR_INPUT,
                    "%s: the box is %g m wide along axis %d, less than the diameter %g m; enlarge it",
                    dem_dict_where(g->dict), g->max[k] - g->min[k], k, g->diameter);
    }
    return DEM_OK;
}

static int insert_lattice(struct dem_crowd *c, struct group *g, const struct dem_recipe *r)
{
    double spacing, jitter, cells = 1.0;
    int64_t n[3];

    DEM_TRY(read_box(g));
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

struct places                                             /* a grid of cells one diameter wide; at most one centre each 1/sqrt 3 */
{
    double edge;
    int64_t cells[3];
    int32_t *first, *next;                                /* chains of particles by cell, -1 ends */
};

static size_t place_of(const struct places *s, const struct group *g, const double x[3], int64_t at[3])
{
    for (int k = 0; k < 3; k++)
    {
        at[k] = (int64_t)((x[k] - g->min[k])/s->edge);
    }
    return (size_t)((at[2]*s->cells[1] + at[1])*s->cells[0] + at[0]);
}

static int is_free(const struct places *s, const struct group *g, const struct dem_particle *placed, const double x[3])
{
    int64_t at[3], c[3];

    (void)place_of(s, g, x, at);
    for (int n = 0; n < 27; n++)
    {
        int inside = 1;

        for (int k = 0; k < 3; k++)
        {
            c[k] = at[k] + (k == 0 ? n%3 : k == 1 ? n/3%3 : n/9) - 1;
            inside &= c[k] >= 0 && c[k] < s->cells[k];
        }
        for (int32_t m = inside ? s->first[(c[2]*s->cells[1] + c[1])*s->cells[0] + c[0]] : -1; m >= 0; m = s->next[m])
        {
            const double dx = x[0] - placed[m].x[0], dy = x[1] - placed[m].x[1], dz = x[2] - placed[m].x[2];

            if (dx*dx + dy*dy + dz*dz < g->diameter*g->diameter)
            {
                return 0;
            }
        }
    }
    return 1;
}

static int place_all(struct dem_crowd *c, struct group *g, const struct dem_recipe *r, struct places *s)
{
    const size_t first = c->n;
    int64_t at[3];

    for (int64_t m = 0; m < g->count; m++)
    {
        double x[3];
        uint64_t trial = 0;

        do
        {
            for (int k = 0; k < 3; k++)
            {
                x[k] = g->min[k] + 0.5*g->diameter + (g->max[k] - g->min[k] - g->diameter)
                     *dem_random_unit((uint64_t)g->seed, (uint64_t)m, trial, USE_PLACE + (uint64_t)k);
            }
            trial++;
        } while (trial < MOST_TRIALS && !is_free(s, g, c->particle + first, x));
        DEM_REQUIRE(trial < MOST_TRIALS, DEM_ERROR_INPUT,
                    "%s: only %lld of %lld particles found room at random (%d trials for the next one); enlarge the box, "
                    "ask for fewer, or use type lattice", dem_dict_where(g->dict), (long long)m, (long long)g->count,
                    MOST_TRIALS);
        const size_t cell = place_of(s, g, x, at);

        s->next[m] = s->first[cell];
        s->first[cell] = (int32_t)m;
        DEM_TRY(add(c, g, r, x, g->diameter));
    }
    return DEM_OK;
}

static int insert_random(struct dem_crowd *c, struct group *g, const struct dem_recipe *r)
{
    struct places s = {.edge = g->diameter};
    double cells = 1.0;

    DEM_TRY(read_box(g));
    do
    {
        cells = 1.0;
        for (int k = 0; k < 3; k++)
        {
            s.cells[k] = (int64_t)((g->max[k] - g->min[k])/s.edge) + 1;
            cells *= (double)s.cells[k];
        }
        s.edge *= cells > 5e7 ? 1.26 : 1.0;
    } while (cells > 5e7);
    DEM_TRY(DEM_NEW(s.first, (size_t)cells + 1));
    DEM_TRY(DEM_NEW(s.next, g->count + 1));
    memset(s.first, -1, ((size_t)cells + 1)*sizeof *s.first);
    const int status = place_all(c, g, r, &s);

    dem_memory_free(s.first);
    dem_memory_free(s.next);
    return status;
}

/* ---- one by one ---------------------------------------------------------------------------------------------- */

static int insert_list(struct dem_crowd *c, struct group *g, const struct dem_recipe *r)
{
    const double (*position)[3], (*velocity)[3] = NULL, (*spin)[3] = NULL, *diameter = NULL;
    size_t n, velocities = 0, spins = 0, diameters = 0;

    DEM_TRY(dem_dict_vectors(g->dict, "positions", "m", &position, &n));
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
    if (!dem_dict_has(dict, "diameters"))
    {
        DEM_TRY(dem_dict_number(dict, "diameter", "m", &g.diameter));
        DEM_REQUIRE(g.diameter > 0.0, DEM_ERROR_INPUT, "%s: diameter %g m; give a number above 0", dem_dict_where(dict), g.diameter);
    }
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
