/*
 * grid_levels.c -- chooses the levels of the cell lists by the estimated cost of the search.
 *
 * Radii are counted in bins of a factor of sqrt 2. The cost of a division into levels is the number
 * of distance tests: within a level 13.5 cells per particle (half of the neighbouring cells and its
 * own), between levels the box of small cells around each large particle. A row of cells costs as
 * much as `row_cost` tests, independent of its content. Starting with one level, the best further
 * division is accepted as long as it lowers the cost. The levels affect the cost only, not the
 * pairs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "contacts/grid.h"
#include <math.h>
#include <string.h>

enum
{
    BINS = 48,                    /* 2^24: above the largest ratio of sizes of a scene */
};

/* Overhead of one row of cells, in distance tests (about 0.3 ns each): finding its ends, and its
   last vector, half full on average. */
static const double row_cost = 8.0;

struct count
{
    double volume;                 /* m3: of the bounding box */
    double n[BINS], radius[BINS];  /* number; m: largest radius of each bin */
};

/* Volume of the bounding box of the particles; returns the smallest radius [m]. */
static double smallest_radius(struct count *c, const struct dem_particles *particles,
                              double max_radius)
{
    double min[3] = {INFINITY, INFINITY, INFINITY}, max[3] = {-INFINITY, -INFINITY, -INFINITY},
           smallest = max_radius;

    for (size_t i = 0; i < particles->n; i++)
    {
        const struct dem_particle *const r = &particles->record[i];

        smallest = r->radius < smallest ? r->radius : smallest;
        for (int k = 0; k < 3; k++)
        {
            min[k] = r->x[k] < min[k] ? r->x[k] : min[k];
            max[k] = r->x[k] > max[k] ? r->x[k] : max[k];
        }
    }
    c->volume = 1.0;
    for (int k = 0; k < 3; k++)
    {
        c->volume *= fmax(max[k] - min[k], 2.0*max_radius);
    }
    return smallest;
}

static void count_radii(struct count *c, const struct dem_particles *particles, double max_radius)
{
    memset(c->n, 0, sizeof c->n);
    memset(c->radius, 0, sizeof c->radius);
    for (size_t i = 0; i < particles->n; i++)
    {
        const double radius = particles->record[i].radius;
        int binary;
        const double mantissa = frexp(max_radius/radius, &binary);  /* in [0.5, 1) */
        const int steps = 2*(binary - 1) + (mantissa > 0.70710678118654752);
        const int bin = steps < 0 ? 0 : steps < BINS ? steps : BINS - 1;

        c->n[bin] += 1.0;
        c->radius[bin] = radius > c->radius[bin] ? radius : c->radius[bin];
    }
}

/* proposed level: bins `first` (large) to `end` (small) */
struct level
{
    int first, end;
    double n, edge, radius;
};

static struct level make_level(const struct count *c, int first, int end, double gap)
{
    struct level p = {.first = first, .end = end};

    for (int b = first; b < end; b++)
    {
        p.n += c->n[b];
        p.radius = fmax(p.radius, c->radius[b]);
    }
    p.edge = 2.0*p.radius + gap;
    return p;
}

/* Estimated number of distance tests of a search. */
static double cost(const struct count *c, const struct level *level, int levels, double gap)
{
    double sum = 0.0;

    for (int a = 0; a < levels; a++)
    {
        const double edge = level[a].edge;

        sum += level[a].n*(13.5*edge*edge*edge*level[a].n/c->volume + 5.0*row_cost);
        for (int b = a + 1; b < levels; b++)
        {
            const double wide = 2.0*(level[a].radius + level[b].radius + gap) + level[b].edge,
                         rows = wide/level[b].edge;

            sum += level[a].n*(wide*wide*wide*level[b].n/c->volume + rows*rows*row_cost);
        }
    }
    return sum;
}

/* Divide part[k] in front of bin `at`. */
static void divide(const struct count *c, struct level *level, int levels, int k, int at,
                   double gap)
{
    memmove(&level[k + 1], &level[k], (size_t)(levels - k)*sizeof *level);
    level[k + 1] = make_level(c, at, level[k].end, gap);
    level[k] = make_level(c, level[k].first, at, gap);
}

/* Divide where it saves most, as long as it saves. One level stays free for larger ghosts. */
static int best_levels(const struct count *c, struct level *level, double gap)
{
    int levels = 1, best_level;

    level[0] = make_level(c, 0, BINS, gap);
    do
    {
        /* the model is rough: demand a gain of 5 % */
        double lowest = 0.95*cost(c, level, levels, gap);
        int best_bin = 0;

        best_level = -1;
        for (int k = 0; k < levels && levels < DEM_GRID_LEVELS - 1; k++)
        {
            for (int at = level[k].first + 1; at < level[k].end; at++)
            {
                struct level other[DEM_GRID_LEVELS];

                memcpy(other, level, sizeof other);
                divide(c, other, levels, k, at, gap);
                const double here = other[k].n > 0.0 && other[k + 1].n > 0.0
                                        ? cost(c, other, levels + 1, gap)
                                        : INFINITY;

                if (here < lowest)
                {
                    lowest = here;
                    best_level = k;
                    best_bin = at;
                }
            }
        }
        if (best_level >= 0)
        {
            divide(c, level, levels++, best_level, best_bin, gap);
        }
    } while (best_level >= 0);
    return levels;
}

/* Ghosts may be larger than all owned particles: they get a level of their own when needed. */
void dem_grid_choose_levels(struct dem_grid *g, const struct dem_particles *particles,
                            double max_radius, double gap)
{
    struct level level[DEM_GRID_LEVELS] = {{.radius = max_radius}};
    struct count c;
    int levels = 1;

    if (particles->n > 0 && smallest_radius(&c, particles, max_radius) < 0.5*max_radius)
    {
        count_radii(&c, particles, max_radius);
        levels = best_levels(&c, level, gap);
    }
    g->gap = gap;
    g->levels = levels;
    for (int k = 0; k < levels; k++)
    {
        g->level[levels - 1 - k].radius = level[k].radius;
    }
    if (level[0].radius < 0.7*max_radius)
    {
        g->levels++;
    }
    g->level[g->levels - 1].radius = max_radius;
    for (int k = 0; k < g->levels; k++)
    {
        g->level[k].edge = 2.0*g->level[k].radius + gap;
    }
}
