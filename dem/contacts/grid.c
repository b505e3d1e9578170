/*
 * grid.c -- builds the cell lists: lists the entries with their images, counts them by cell, sorts
 * them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "contacts/grid.h"
#include "core/error.h"
#include "core/memory.h"
#include <float.h>
#include <math.h>
#include <string.h>

enum
{
    MAX_CELLS_PER_ENTRY = 8,      /* limit of cells per entry; above it cells get wider */
    PADDING = 8                   /* entries that may be read past the last one */
};

struct box
{
    double min[3], max[3];        /* m */
};

static const struct box empty_box = {{INFINITY, INFINITY, INFINITY},
                                     {-INFINITY, -INFINITY, -INFINITY}};

/* Axes of the grid, the shortest side of the bounding box first: contact partners are then as near
   each other in memory as possible. */
static void choose_axes(struct dem_grid *g, const struct box *b)
{
    for (int k = 0; k < 3; k++)
    {
        int index = 0;

        for (int m = 0; m < 3; m++)
        {
            const double side = b->max[k] - b->min[k], other = b->max[m] - b->min[m];

            index += other < side || (other == side && m < k);
        }
        g->axis[index] = k;
    }
}

static void enclose(struct box *b, const double x[3])
{
    for (int k = 0; k < 3; k++)
    {
        b->min[k] = x[k] < b->min[k] ? x[k] : b->min[k];
        b->max[k] = x[k] > b->max[k] ? x[k] : b->max[k];
    }
}

static struct box owned_box(const struct dem_particles *particles)
{
    struct box b = empty_box;

    for (size_t i = 0; i < particles->n; i++)
    {
        enclose(&b, particles->record[i].x);
    }
    return b;
}

/* Cover a box with cells, wider ones when there would be too many for `count` entries. Returns
   their number. */
static size_t size_level(const struct dem_grid *g, struct dem_grid_level *l, const struct box *b,
                         size_t count)
{
    const double limit = MAX_CELLS_PER_ENTRY*(double)count + 64.0;
    double cells;

    do
    {
        cells = 1.0;
        for (int k = 0; k < 3; k++)
        {
            const double side = b->max[g->axis[k]] - b->min[g->axis[k]];

            l->cells[k] = side > 0.0 ? (int)fmin(1e6, side/l->edge) + 1 : 1;
            cells *= l->cells[k];
        }
        l->edge *= cells > limit ? 1.26 : 1.0;
    } while (cells > limit);
    return (size_t)cells;
}

static size_t cell_of(const struct dem_grid *g, const struct dem_grid_level *l, const double x[3])
{
    int c[3];

    dem_grid_cells(g, l, x, c);
    return l->first + ((size_t)c[2]*(size_t)l->cells[1] + (size_t)c[1])*(size_t)l->cells[0] +
           (size_t)c[0];
}

size_t dem_grid_fit(struct dem_grid *g, struct dem_grid_level *l,
                    const struct dem_particles *particles)
{
    const struct box b = owned_box(particles);

    choose_axes(g, &b);
    memcpy(g->origin, b.min, sizeof g->origin);
    return size_level(g, l, &b, particles->n);
}

/* ---- entries --------------------------------------------------------------------------------- */

struct dem_grid_entry
{
    uint32_t particle, cell;
    uint8_t shift, level;
};

static uint8_t level_of(const struct dem_grid *g, double radius)
{
    int l = 0;

    while (l + 1 < g->levels && radius > g->level[l].radius)
    {
        l++;
    }
    return (uint8_t)l;
}

/* Shifts by -1, 0, 1 box lengths along each axis that bring x within `reach` of the box, as bits 0,
   1, 2. */
static void shifts_inside(const struct dem_domain *d, const double x[3], double reach,
                          const struct box *b, unsigned inside[3])
{
    for (int k = 0; k < 3; k++)
    {
        const double min = b->min[k] - reach, max = b->max[k] + reach;

        inside[k] = (x[k] > min && x[k] < max) ? 2u : 0u;
        if (d->periodic[k])
        {
            inside[k] |= (x[k] - d->length[k] > min && x[k] - d->length[k] < max) ? 1u : 0u;
            inside[k] |= (x[k] + d->length[k] > min && x[k] + d->length[k] < max) ? 4u : 0u;
        }
    }
}

/* 1 when the image of x at this shift lies within `reach` of the box. */
static int is_inside(const double x[3], const double shift[4], double reach, const struct box *b)
{
    int inside = 1;

    for (int k = 0; k < 3; k++)
    {
        inside &= x[k] + shift[k] > b->min[k] - reach && x[k] + shift[k] < b->max[k] + reach;
    }
    return inside;
}

static void add_entry(struct dem_grid *g, const struct dem_particle *r, const double shift[4],
                      struct dem_grid_entry as, struct box *all)
{
    const double x[3] = {r->x[0] + shift[0], r->x[1] + shift[1], r->x[2] + shift[2]};

    as.level = level_of(g, r->radius);
    g->unsorted[g->entries++] = as;
    enclose(all, x);
}

/* List each record at each shift that brings it within reach of the bounding box of the owned
   particles. `all`: bounding box of the entries. */
static int list_entries(struct dem_grid *g, const struct dem_domain *d,
                        const struct dem_particles *particles, double shift[DEM_SHIFTS][4],
                        struct box *all)
{
    const double reach = g->gap + g->level[g->levels - 1].radius;
    const struct box owned = owned_box(particles);

    choose_axes(g, &owned);
    *all = empty_box;
    g->entries = 0;
    DEM_TRY(DEM_GROW(g->unsorted, g->unsorted_capacity,
                     particles->n + particles->ghosts + particles->n/4 + DEM_SHIFTS));
    for (size_t i = 0; i < particles->n + particles->ghosts; i++)
    {
        const struct dem_particle *const r = &particles->record[i];
        struct dem_grid_entry e = {.particle = (uint32_t)i, .shift = DEM_SHIFT_NONE};
        unsigned inside[3];

        shifts_inside(d, r->x, reach + r->radius, &owned, inside);
        if (d->offset == 0.0 && inside[0] == 2u && inside[1] == 2u && inside[2] == 2u)    /* most particles */
        {
            DEM_TRY(DEM_GROW(g->unsorted, g->unsorted_capacity, g->entries + 1));
            add_entry(g, r, shift[DEM_SHIFT_NONE], e, all);
            continue;
        }
        DEM_TRY(DEM_GROW(g->unsorted, g->unsorted_capacity, g->entries + DEM_SHIFTS));
        for (e.shift = 0; e.shift < DEM_SHIFTS; e.shift++)
        {
            if (d->offset != 0.0
                    ? dem_domain_has_shift(d, e.shift) && is_inside(r->x, shift[e.shift], reach + r->radius, &owned)
                    : (int)(inside[0] >> e.shift%3 & inside[1] >> e.shift/3%3 & inside[2] >> e.shift/9 & 1u))
            {
                add_entry(g, r, shift[e.shift], e, all);
            }
        }
    }
    return DEM_OK;
}

static int size_levels(struct dem_grid *g, const struct box *all)
{
    size_t count[DEM_GRID_LEVELS] = {0}, cells = 0;

    for (size_t e = 0; e < g->entries; e++)
    {
        count[g->unsorted[e].level]++;
    }
    for (int k = 0; k < g->levels; k++)
    {
        g->level[k].first = cells;
        cells += size_level(g, &g->level[k], all, count[k]);
    }
    memcpy(g->origin, all->min, sizeof g->origin);
    DEM_TRY(DEM_GROW(g->start, g->start_capacity, cells + 2));
    memset(g->start, 0, (cells + 2)*sizeof *g->start);
    return DEM_OK;
}

static void find_slack(struct dem_grid *g, const struct box *all)
{
    double extent = 0.0;

    for (int k = 0; k < 3; k++)
    {
        extent = fmax(extent, all->max[k] - all->min[k]);
    }
    /* both positions and their difference are rounded to half a unit in the last place, times sqrt
       3; the factor is 4 where 3 would suffice */
    g->slack = (float)(4.0*FLT_EPSILON*(extent + g->level[g->levels - 1].edge));
}

static int reserve_entries(struct dem_grid *g)
{
    const size_t capacity = dem_memory_capacity(g->capacity, g->entries + PADDING);

    DEM_TRY(DEM_RESIZE(g->x, g->capacity, capacity));
    DEM_TRY(DEM_RESIZE(g->y, g->capacity, capacity));
    DEM_TRY(DEM_RESIZE(g->z, g->capacity, capacity));
    DEM_TRY(DEM_RESIZE(g->radius, g->capacity, capacity));
    DEM_TRY(DEM_RESIZE(g->particle, g->capacity, capacity));
    DEM_TRY(DEM_RESIZE(g->shift, g->capacity, capacity));
    g->capacity = capacity;
    return DEM_OK;
}

/* Position of an entry [m]. */
static void position_of(const struct dem_particles *particles, double shift[DEM_SHIFTS][4],
                        const struct dem_grid_entry *e, double x[3])
{
    for (int k = 0; k < 3; k++)
    {
        x[k] = particles->record[e->particle].x[k] + shift[e->shift][k];
    }
}

static void put_entries(struct dem_grid *g, const struct dem_particles *particles,
                        double shift[DEM_SHIFTS][4])
{
    double x[3];

    for (size_t k = 0; k < g->entries; k++)
    {
        const struct dem_grid_entry *const from = &g->unsorted[k];
        const uint32_t e = g->start[from->cell + 1]++;

        position_of(particles, shift, from, x);
        g->x[e] = (float)(x[g->axis[0]] - g->origin[g->axis[0]]);
        g->y[e] = (float)(x[g->axis[1]] - g->origin[g->axis[1]]);
        g->z[e] = (float)(x[g->axis[2]] - g->origin[g->axis[2]]);
        g->radius[e] = (float)particles->record[from->particle].radius;
        g->particle[e] = from->particle;
        g->shift[e] = from->shift;
    }
}

int dem_grid_fill(struct dem_grid *g, const struct dem_domain *d,
                  const struct dem_particles *particles, double shift[DEM_SHIFTS][4])
{
    const struct dem_grid_level *const last = &g->level[g->levels - 1];
    struct box all;
    double x[3];

    DEM_TRY(list_entries(g, d, particles, shift, &all));
    DEM_TRY(size_levels(g, &all));
    DEM_TRY(reserve_entries(g));
    find_slack(g, &all);
    for (size_t e = 0; e < g->entries; e++)
    {
        struct dem_grid_entry *const to = &g->unsorted[e];

        position_of(particles, shift, to, x);
        to->cell = (uint32_t)cell_of(g, &g->level[to->level], x);
        g->start[to->cell + 2]++;
    }
    /* counts are stored two indices ahead: start[c + 1] is the next free entry of cell c while
       entries are written, and its end afterwards */
    dem_grid_starts(g->start,
                    last->first +
                        (size_t)last->cells[0]*(size_t)last->cells[1]*(size_t)last->cells[2] +
                        1);
    put_entries(g, particles, shift);
    return DEM_OK;
}

void dem_grid_free(struct dem_grid *g)
{
    dem_memory_free(g->start);
    dem_memory_free(g->x);
    dem_memory_free(g->y);
    dem_memory_free(g->z);
    dem_memory_free(g->radius);
    dem_memory_free(g->particle);
    dem_memory_free(g->shift);
    dem_memory_free(g->unsorted);
    memset(g, 0, sizeof *g);
}
