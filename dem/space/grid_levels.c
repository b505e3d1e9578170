/*
 * grid_levels.c -- into how many levels of cells the sizes of particles are divided.
 *
 * Radii are counted in steps of a factor of sqrt 2. A division is as good as the distance tests that a search makes with it:
 * within a level 13.5 cells a particle (half of those around it and its own), between levels the box of small cells around each
 * large particle; a row of cells costs as much as `row` tests, whatever is in it. Beginning with one level the best place to divide is taken as
 * long as it saves something. Only cost depends on it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/grid.h"
#include <math.h>
#include <string.h>

enum
{
    BINS = 48,                                            /* 2^24: more than the largest ratio of sizes that a scene may have */
};

/* Of one row of cells, in distance tests (about 0.3 ns each): finding its ends and the last, half full vector. */
static const double row = 8.0;

struct count
{
    double volume;                                        /* m3: that they are in */
    double n[BINS], radius[BINS];                         /* m: the largest in each */
};

/* The box of the particles; returns the smallest radius [m]. */
static double survey(struct count *c, const struct dem_particles *p, double most)
{
    double min[3] = {INFINITY, INFINITY, INFINITY}, max[3] = {-INFINITY, -INFINITY, -INFINITY}, least = most;

    for (size_t i = 0; i < p->n; i++)
    {
        const struct dem_particle *const r = &p->record[i];

        least = r->radius < least ? r->radius : least;
        for (int k = 0; k < 3; k++)
        {
            min[k] = r->x[k] < min[k] ? r->x[k] : min[k];
            max[k] = r->x[k] > max[k] ? r->x[k] : max[k];
        }
    }
    c->volume = 1.0;
    for (int k = 0; k < 3; k++)
    {
        c->volume *= fmax(max[k] - min[k], 2.0*most);
    }
    return least;
}

static void count_radii(struct count *c, const struct dem_particles *p, double most)
{
    memset(c->n, 0, sizeof c->n);
    memset(c->radius, 0, sizeof c->radius);
    for (size_t i = 0; i < p->n; i++)
    {
        const double radius = p->record[i].radius;
        int binary;
        const double part = frexp(most/radius, &binary);  /* in [0.5, 1) */
        const int steps = 2*(binary - 1) + (part > 0.70710678118654752), bin = steps < 0 ? 0 : steps < BINS ? steps : BINS - 1;

        c->n[bin] += 1.0;
        c->radius[bin] = radius > c->radius[bin] ? radius : c->radius[bin];
    }
}

struct part                                               /* a level to be: bins from `first` (large) up to `end` (small) */
{
    int first, end;
    double n, edge, radius;
};

static struct part part_of(const struct count *c, int first, int end, double gap)
{
    struct part p = {.first = first, .end = end};

    for (int b = first; b < end; b++)
    {
        p.n += c->n[b];
        p.radius = fmax(p.radius, c->radius[b]);
    }
    p.edge = 2.0*p.radius + gap;
    return p;
}

/* Tests that a search makes. */
static double work(const struct count *c, const struct part *part, int parts, double gap)
{
    double sum = 0.0;

    for (int a = 0; a < parts; a++)
    {
        const double edge = part[a].edge;

        sum += part[a].n*(13.5*edge*edge*edge*part[a].n/c->volume + 5.0*row);
        for (int b = a + 1; b < parts; b++)
        {
            const double wide = 2.0*(part[a].radius + part[b].radius + gap) + part[b].edge, rows = wide/part[b].edge;

            sum += part[a].n*(wide*wide*wide*part[b].n/c->volume + rows*rows*row);
        }
    }
    return sum;
}

/* Divide part[k] before bin `at`. */
static void divide(const struct count *c, struct part *part, int parts, int k, int at, double gap)
{
    memmove(&part[k + 1], &part[k], (size_t)(parts - k)*sizeof *part);
    part[k + 1] = part_of(c, at, part[k].end, gap);
    part[k] = part_of(c, part[k].first, at, gap);
}

/* Divide where it saves most, as long as it saves something. One level is left free. */
static int best_parts(const struct count *c, struct part *part, double gap)
{
    int parts = 1, best_part;

    part[0] = part_of(c, 0, BINS, gap);
    do
    {
        double least = 0.95*work(c, part, parts, gap);    /* a model this rough should promise more than nothing */
        int best_bin = 0;

        best_part = -1;
        for (int k = 0; k < parts && parts < DEM_GRID_LEVELS - 1; k++)
        {
            for (int at = part[k].first + 1; at < part[k].end; at++)
            {
                struct part other[DEM_GRID_LEVELS];

                memcpy(other, part, sizeof other);
                divide(c, other, parts, k, at, gap);
                const double here = other[k].n > 0.0 && other[k + 1].n > 0.0 ? work(c, other, parts + 1, gap) : INFINITY;

                if (here < least)
                {
                    least = here;
                    best_part = k;
                    best_bin = at;
                }
            }
        }
        if (best_part >= 0)
        {
            divide(c, part, parts++, best_part, best_bin, gap);
        }
    } while (best_part >= 0);
    return parts;
}

/* From here on copies of other ranks' particles count as well: they may be larger than all that are owned. */
void dem_grid_divide(struct dem_grid *g, const struct dem_particles *p, double most_radius, double gap)
{
    struct part part[DEM_GRID_LEVELS] = {{.radius = most_radius}};
    struct count c;
    int parts = 1;

    if (p->n > 0 && survey(&c, p, most_radius) < 0.5*most_radius)
    {
        count_radii(&c, p, most_radius);
        parts = best_parts(&c, part, gap);
    }
    g->gap = gap;
    g->levels = parts;
    for (int k = 0; k < parts; k++)
    {
        g->level[parts - 1 - k].radius = part[k].radius;
    }
    if (part[0].radius < 0.7*most_radius)
    {
        g->levels++;
    }
    g->level[g->levels - 1].radius = most_radius;
    for (int k = 0; k < g->levels; k++)
    {
        g->level[k].edge = 2.0*g->level[k].radius + gap;
    }
}
