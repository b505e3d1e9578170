/*
 * grid.h -- cells of particles for one search: made, searched and thrown away. Large particles have wider cells than small ones.
 *
 * A level holds the particles between two radii in cells as wide as two of its largest and a gap, so that who is near lies in the
 * same cell or in one beside it. How many levels there are, and where radii are divided, follows from what the search would cost
 * (grid_levels.c): one where sizes are alike, two or three at 1:20.
 *
 * Entries are particles, copies, and periodic images of both at shifted places: within a level sorted by cell, along x first (which is
 * the grid's x, the shortest side of the particles' box: planes across its longest side are small enough for a cache), so
 * that three cells side by side are one run of numbers. Their places are single precision from the corner of the grid, for a test
 * that lets no pair slip (by `slack`) but lets through a few too many; the true coordinates decide.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_SPACE_GRID_H
#define DEM_SPACE_GRID_H

#include "space/domain.h"
#include "state/particles.h"

enum
{
    DEM_GRID_LEVELS = 8
};

struct dem_grid_level
{
    double radius;                                        /* m: none of its particles is larger */
    double edge;                                          /* m: of a cell */
    int cells[3];                                         /* along the grid's axes */
    size_t first;                                         /* its first cell in dem_grid.start */
};

struct dem_grid
{
    double gap;                                           /* m: pairs nearer than this are looked for */
    double origin[3];                                     /* m: corner of all levels */
    int axis[3];                                          /* cells follow each other along axis[0] of space first, axis[2] last: the
                                                             longest side of the particles' box */
    int levels;
    struct dem_grid_level level[DEM_GRID_LEVELS];         /* from the smallest particles up */
    uint32_t *start;                                      /* of each cell's entries, those of the finest level first */
    size_t entries;
    float *x, *y, *z, *radius;                            /* m: from the corner, along the grid's axes */
    float slack;                                          /* m: what single precision may hide of a distance */
    uint32_t *particle;
    uint8_t *shift;                                       /* code */
};

/* Divide the radii [m] of the owned particles into levels; `most_radius`: of all ranks. */
void dem_grid_divide(struct dem_grid *, const struct dem_particles *, double most_radius, double gap);

/* Owned particles by cell of the finest level, and by id within a cell: layer by layer along the longest side, in columns where layers are
   wide, so that partners are near each other in memory. */
int dem_grid_order(struct dem_grid *, const struct dem_particles *, uint32_t *order);

/* Turn the axes by the box of the owned particles, put the origin in its corner and cells of a level over it, wider ones where most would
   be empty. Returns how many. */
size_t dem_grid_lay(struct dem_grid *, struct dem_grid_level *, const struct dem_particles *);

/* Sort all that may be near an owned particle into the cells of the levels that are divided. */
int dem_grid_fill(struct dem_grid *, const struct dem_domain *, const struct dem_particles *, double shift[DEM_SHIFTS][4]);

/* Give back what fill took. */
void dem_grid_empty(struct dem_grid *);

/* The cell along an axis that holds a coordinate [m], from the corner of the grid. */
static inline int dem_grid_cell(const struct dem_grid_level *l, double x, int axis)
{
    const double c = x/l->edge;

    return c >= l->cells[axis] ? l->cells[axis] - 1 : c > 0.0 ? (int)c : 0;
}

/* The same along the three of them, of a place in space [m]. */
static inline void dem_grid_cells(const struct dem_grid *g, const struct dem_grid_level *l, const double x[3], int c[3])
{
    for (int k = 0; k < 3; k++)
    {
        c[k] = dem_grid_cell(l, x[g->axis[k]] - g->origin[g->axis[k]], k);
    }
}

/* Counts of cells c, at place c + 1, become places of their first entries. */
static inline void dem_grid_starts(uint32_t *start, size_t cells)
{
    for (size_t c = 1; c <= cells; c++)
    {
        start[c] += start[c - 1];
    }
}

/* The entries of the cells from x = a to b of the row (y, z) are those from dem_grid_run(.., a) up to dem_grid_run(.., b + 1). */
static inline uint32_t dem_grid_run(const struct dem_grid *g, const struct dem_grid_level *l, int x, int y, int z)
{
    return g->start[l->first + ((size_t)z*(size_t)l->cells[1] + (size_t)y)*(size_t)l->cells[0] + (size_t)x];
}

#endif
