/*
 * grid.h -- cell lists for one search of neighbours, on several levels when radii differ.
 *
 * A level holds the particles between two radii, in cells as wide as twice its largest radius plus
 * the gap, so that neighbours within a level lie in the same or in adjacent cells. The number of
 * levels and the radii that divide them minimise the estimated cost of the search (grid_levels.c):
 * one level for equal sizes, two or three for a ratio of 1:20.
 *
 * Entries are particles, ghosts, and periodic images of both at shifted positions. Within a level
 * they are sorted by cell, along the x of the grid first, so that three adjacent cells are one
 * contiguous run. The x of the grid is the shortest side of the bounding box of the particles:
 * layers across its longest side are then small enough for a cache. Positions of entries are single
 * precision relative to the corner of the grid, for a preliminary test that misses no pair
 * (tolerance `slack`) but accepts a few too many; the pair is decided in double precision.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/domain.h"
#include "particles/particles.h"

enum
{
    DEM_GRID_LEVELS = 8
};

struct dem_grid_level
{
    double radius;                /* m: largest radius of its particles */
    double edge;                  /* m: of a cell */
    int cells[3];                 /* along the axes of the grid */
    size_t first;                 /* index of its first cell in dem_grid.start */
};

struct dem_grid_entry;            /* grid.c */

struct dem_grid                   /* all zero: empty; its arrays serve the next search too */
{
    double gap;                                    /* m: pairs with a smaller gap are searched */
    double origin[3];                              /* m: corner of all levels */
    int axis[3];                                   /* axes of the grid: axis[0], fastest in memory,
                                                      is the shortest side of the bounding box,
                                                      axis[2] the longest */
    int levels;
    struct dem_grid_level level[DEM_GRID_LEVELS];  /* from the smallest particles up */
    uint32_t *start;                               /* of each cell's entries, the finest level
                                                      first */
    size_t entries;
    float *x, *y, *z, *radius;                     /* m: from the corner, along the axes of the
                                                      grid */
    float slack;                                   /* m: bound of the error of distances in single
                                                      precision */
    uint32_t *particle;
    uint8_t *shift;                                /* shift code of the image */
    struct dem_grid_entry *unsorted;               /* the entries before they are sorted */
    size_t start_capacity, capacity, unsorted_capacity;
};

/* Divide the radii [m] of the owned particles into levels. max_radius [m]: largest of all ranks.
   gap [m]. */
void dem_grid_choose_levels(struct dem_grid *, const struct dem_particles *, double max_radius,
                            double gap);

/* Compute the order of the owned particles: by cell of the finest level, by id within a cell. Cells
   are ordered layer by layer along the longest side, in columns when layers are wide, so that
   partners are near each other in memory. */
int dem_grid_order(struct dem_grid *, const struct dem_particles *, uint32_t *order);

/* Choose axes and origin from the bounding box of the owned particles and cover it with the cells
   of a level; cells are wider when most of them would be empty. Returns the number of cells. */
size_t dem_grid_fit(struct dem_grid *, struct dem_grid_level *, const struct dem_particles *);

/* Sort all particles and images that may be near an owned particle into the cells of the levels. */
int dem_grid_fill(struct dem_grid *, const struct dem_domain *, const struct dem_particles *,
                  double shift[DEM_SHIFTS][4]);

void dem_grid_free(struct dem_grid *);

/* Index of the cell along an axis that holds a coordinate [m] relative to the corner of the
   grid. */
static inline int dem_grid_cell(const struct dem_grid_level *l, double x, int axis)
{
    const double c = x/l->edge;

    return c >= l->cells[axis] ? l->cells[axis] - 1 : c > 0.0 ? (int)c : 0;
}

/* The same along all three axes, for a position x [m]. */
static inline void dem_grid_cells(const struct dem_grid *g, const struct dem_grid_level *l,
                                  const double x[3], int c[3])
{
    for (int k = 0; k < 3; k++)
    {
        c[k] = dem_grid_cell(l, x[g->axis[k]] - g->origin[g->axis[k]], k);
    }
}

/* Turn the counts of cells c, stored at index c + 1, into the indices of their first entries. */
static inline void dem_grid_starts(uint32_t *start, size_t cells)
{
    for (size_t c = 1; c <= cells; c++)
    {
        start[c] += start[c - 1];
    }
}

/* First entry of a cell: the entries of cells x = a to b of the row (y, z) are those from
   dem_grid_first_entry(.., a) up to, without, dem_grid_first_entry(.., b + 1). */
static inline uint32_t dem_grid_first_entry(const struct dem_grid *g,
                                            const struct dem_grid_level *l, int x, int y, int z)
{
    return g->start[l->first + ((size_t)z*(size_t)l->cells[1] + (size_t)y)*(size_t)l->cells[0] +
                    (size_t)x];
}
