/*
 * wall_search.h -- which regions of the walls a particle may reach before the next rebuild, found through a grid.
 *
 * For each particle and region within reach one dem_wall_near: either "open" (no rim of the region is in reach, so the
 * region is as good as its whole plane, cylinder or sphere) or with the list of its triangles in reach. Triangles are
 * searched in the frame of their wall, so the grid is made once, wherever walls move. Only where walls follow a mesh it is
 * made anew for each search after they have moved.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_SPACE_WALL_SEARCH_H
#define DEM_SPACE_WALL_SEARCH_H

#include "state/particles.h"
#include "state/walls.h"

struct dem_wall_near
{
    uint32_t particle;
    int region;
    int open;                                             /* 1: contact with the plane itself */
    uint32_t first, count;                                /* triangles, in dem_wall_search.candidate */
};

struct dem_wall_search
{
    double origin[3], edge;                               /* of the grid [m] */
    int cells[3];
    size_t *start;                                        /* cells + 1 */
    uint32_t *entry;                                      /* triangles by cell */
    size_t nears, near_room, candidates, candidate_room;
    struct dem_wall_near *near;                           /* by particle, then region */
    uint32_t *candidate;
    uint32_t *seen;                                       /* stamp of the last particle that met each triangle */
    uint32_t stamp;
    double radius, journey;                               /* m: that the grid suits; of the walls when it was made */
};

void dem_wall_search_free(struct dem_wall_search *);

/* Sort the triangles into a grid whose cells suit particles of this radius [m]. After the walls are finished. */
int dem_wall_search_prepare(struct dem_wall_search *, const struct dem_walls *, double radius);

/* All nears of the owned particles, within `skin` [m] past touching. */
int dem_wall_search_find(struct dem_wall_search *, const struct dem_walls *, const struct dem_particles *, double skin);

/* Does a sphere touch no wall, and lie on the side of each where particles live? The nears that were found stay. */
int dem_wall_search_is_clear(struct dem_wall_search *, const struct dem_walls *, const struct dem_particle *, int *clear);

/* How far [m] a point of the world is from the region of a near, as contacts see it: negative behind what has one side. */
double dem_wall_search_distance(const struct dem_wall_search *, const struct dem_walls *, const struct dem_wall_near *,
                                const double x[3]);

/* The nearest point of a near's triangles to x, which is in their wall's frame. Returns the distance [m]. */
double dem_wall_search_nearest(const struct dem_wall_search *, const struct dem_walls *, const struct dem_wall_near *, const double x[3],
                               double point[3]);

/* 1 when contact is with the plane itself; a region that has bent since the search has none. */
static inline int dem_wall_near_open(const struct dem_walls *w, const struct dem_wall_near *near)
{
    return near->open && !w->region[near->region].bent;
}

/* Of a near's triangles the one nearest to x, the first of several alike. */
uint32_t dem_wall_near_triangle(const struct dem_wall_search *, const struct dem_walls *, const struct dem_wall_near *, const double x[3]);

/* The point of a triangle nearest to x (Voronoi regions of the triangle). Returns the squared distance [m2]. */
double dem_triangle_nearest(const struct dem_triangle *, const double x[3], double nearest[3]);

#endif
