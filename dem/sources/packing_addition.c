/*
 * packing_addition.c -- random sequential addition in rounds: in each round every remaining sphere
 * tries one random position.
 *
 * A position is free when it overlaps no placed sphere, and no trial position of this round of a
 * larger sphere, or of an equal one with a lower number, whether that is placed or not. So the
 * result does not depend on the order of the tests. Octaves of diameters follow one another,
 * largest first. Rounds of an octave end when fewer than one in sixteen of the tried spheres is
 * placed.
 *
 * This is not the sequential process (Widom, J. Chem. Phys. 44 (1966) 3888), but agrees with it in
 * the first two orders of the density.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/packing.h"
#include "core/error.h"
#include "core/memory.h"
#include "ranks/collect.h"

enum
{
    OCTAVES = 12,     /* of diameters; the last holds all smaller ones */
    ROUNDS = 64,
    SCARCE = 16       /* the last round places fewer than one in so many */
};

/* v[0] of a sphere: its state */
static const double placed = 0.0, tried = 1.0;

static int is_tried(const struct dem_particle *s)
{
    return s->v[0] > placed;
}

/* A sphere of this rank found no place off the walls and inside the mesh. */
static int no_place(const struct dem_packing *p, const struct dem_particle *s)
{
    return dem_error(
        DEM_ERROR_INPUT,
        "%s: a sphere of %g m finds no place off the walls inside its region, the box "
        "from (%g %g %g) to (%g %g %g) m, in %d trials; enlarge the region, or ask for "
        "smaller ones",
        p->where, 2.0*s->radius, p->shape->min[0], p->shape->min[1], p->shape->min[2],
        p->shape->max[0], p->shape->max[1], p->shape->max[2], DEM_PACKING_LIMITED_DRAWS);
}

/* The octave of a radius below the largest; the last holds all smaller ones. */
static int octave_of(const struct dem_packing_spheres *s, double radius)
{
    int k = 0;

    for (double edge = 0.5*s->max_radius; k < OCTAVES - 1 && radius <= edge; edge *= 0.5)
    {
        k++;
    }
    return k;
}

/* The spheres of this octave in this rank's run of the list are to be tried. */
static int begin_octave(const struct dem_packing *p, struct dem_packing_spheres *s, int octave)
{
    const int64_t ranks = s->decomposition.ranks, from = p->n*s->decomposition.rank/ranks;
    const int64_t to = p->n*(s->decomposition.rank + 1)/ranks;

    for (int64_t m = from; m < to; m++)
    {
        const struct dem_particle sphere =
            {.radius = 0.5*(p->diameters ? p->diameters[m] : p->diameter), .v = {tried}, .id = m};

        if (octave_of(s, sphere.radius) == octave)
        {
            DEM_TRY(dem_particles_add(&s->particles, &sphere));
        }
    }
    return DEM_OK;
}

/* A new trial position for each. */
static int draw_all(const struct dem_packing *p, struct dem_packing_spheres *s, uint64_t round)
{
    for (size_t i = 0; i < s->particles.n; i++)
    {
        struct dem_particle *const sphere = &s->particles.record[i];

        if (is_tried(sphere) && !dem_packing_draw(p, sphere, round) && p->shape->limits)
        {
            DEM_TRY(p->shape->limits->status);
            return no_place(p, sphere);
        }
    }
    return DEM_OK;
}

/* Does a precede b in a round? */
static int precedes(const struct dem_particle *a, const struct dem_particle *b)
{
    return !is_tried(a) || a->radius > b->radius || (a->radius >= b->radius && a->id < b->id);
}

/* Place the tried spheres without an overlap that precedes them. `taken`: zeroed, a byte a sphere.
   count: of this rank, placed ones and remaining ones. */
static void place_free(struct dem_packing_spheres *s, uint8_t *taken, int64_t count[2])
{
    struct dem_particle *const record = s->particles.record;

    for (size_t k = 0; k < s->contacts.pairs.n; k++)
    {
        const uint32_t i = s->contacts.pairs.pair[k].i, j = s->contacts.pairs.pair[k].j;

        taken[is_tried(&record[i]) && precedes(&record[j], &record[i]) ? i : j] = 1;
    }
    for (size_t i = 0; i < s->particles.n; i++)
    {
        if (is_tried(&record[i]))
        {
            record[i].v[0] = taken[i] ? tried : placed;
            count[taken[i]]++;
        }
    }
}

static int try_all(const struct dem_packing *p, struct dem_packing_spheres *s, uint64_t round,
                   int status, int64_t count[2])
{
    uint8_t *taken = NULL;

    status = status ? status : draw_all(p, s, round);
    DEM_TRY(dem_packing_list_pairs(p, s, status, 0.0));
    status = DEM_NEW(taken, s->particles.n + s->particles.ghosts + 1);
    count[0] = count[1] = 0;
    if (!status)
    {
        place_free(s, taken, count);
    }
    dem_memory_free(taken);
    DEM_TRY(dem_collect_agree(&s->decomposition, status));
    dem_collect_sum_int64(&s->decomposition, count, 2);
    return dem_collect_status(&s->decomposition);
}

/* Rounds of an octave; *left: those that have found no free position. */
static int place_octave(const struct dem_packing *p, struct dem_packing_spheres *s, int octave,
                        int64_t *left)
{
    int status = begin_octave(p, s, octave);
    int64_t count[2] = {1, 1};

    for (uint64_t round = 0; round < ROUNDS && count[1] > 0 && count[0]*SCARCE >= count[1]; round++)
    {
        DEM_TRY(try_all(p, s, round, status, count));
        status = DEM_OK;
    }
    *left += count[1];
    for (size_t i = 0; i < s->particles.n; i++)    /* those that overlap: relaxation moves them */
    {
        s->particles.record[i].v[0] = placed;
    }
    return DEM_OK;
}

/* Octaves that have new spheres, which all ranks know. */
static void find_octaves(const struct dem_packing *p, const struct dem_packing_spheres *s,
                         int has[OCTAVES])
{
    for (int64_t m = 0; m < (p->diameters ? p->n : 1); m++)
    {
        has[octave_of(s, 0.5*(p->diameters ? p->diameters[m] : p->diameter))] = 1;
    }
}

int dem_packing_place(const struct dem_packing *p, struct dem_packing_spheres *s, int64_t *left)
{
    int has[OCTAVES] = {0};

    *left = 0;
    find_octaves(p, s, has);
    for (int octave = 0; octave < OCTAVES; octave++)
    {
        DEM_TRY(has[octave] ? place_octave(p, s, octave, left) : DEM_OK);
    }
    return DEM_OK;
}
