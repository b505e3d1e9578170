/*
 * wall_search.h -- search for the wall facets that each particle may reach before the next search.
 *
 * For each particle and facet within reach there is one wall neighbor. It is either "open": no rim
 * of the facet is in reach, so the contact is with the unbounded plane, cylinder or sphere; or
 * it has the list of triangles in reach. Triangles are searched in the reference frame of their
 * wall, so the grid of triangles is built once, however walls move. Walls that follow a mesh change
 * their shape: after they have moved, the next search builds the grid anew. A particle near a
 * periodic face meets images of triangles: the search is repeated at its position less whole
 * periods. All triangles in reach of one image of a facet are one wall neighbor.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/particles.h"
#include "walls/triangle_nearest.h"
#include "walls/walls.h"

/* wall neighbor: a particle and a facet */
struct dem_wall_neighbor
{
    uint32_t particle;
    int facet;
    uint8_t open;                 /* 1: contact with the unbounded surface */
    int8_t image[3];              /* of the facet: whole periods off its place */
    uint32_t first, count;        /* triangles, in dem_wall_search.candidate */
};

/* image of a triangle: whole periods off the triangle */
struct dem_wall_image
{
    int8_t n[3];
};

struct dem_wall_search
{
    double origin[3], edge;       /* of the grid [m] */
    int cells[3];
    size_t *start;                /* cells + 1 */
    uint32_t *entry;              /* triangles by cell */
    size_t neighbors, neighbor_capacity, candidates, candidate_capacity;
    struct dem_wall_neighbor *neighbor;  /* by particle, then facet */
    uint32_t *candidate;          /* triangles in reach, one list per wall neighbor */
    struct dem_wall_image *image; /* of each candidate; NULL without periodic walls */
    size_t image_capacity;
    uint32_t *seen;               /* stamp of the last search that met each triangle */
    uint32_t stamp;
    double radius, path_length;   /* m: particle radius for which the grid was built; path of the
                                     walls (dem_walls) when it was built */
};

void dem_wall_search_free(struct dem_wall_search *);

/* Sort the triangles into a grid with cells for particles of this radius [m]. After
   dem_walls_finish. */
int dem_wall_search_prepare(struct dem_wall_search *, const struct dem_walls *, double radius);

/* Find all wall neighbors of the owned particles within `skin` [m] past touching. */
int dem_wall_search_find(struct dem_wall_search *, const struct dem_walls *,
                         const struct dem_particles *, double skin);

/* clear: 1 when a sphere touches no wall and lies on the particles' side of each. The wall
   neighbors found before are kept. */
int dem_wall_search_is_clear(struct dem_wall_search *, const struct dem_walls *,
                             const struct dem_particle *, int *clear);

/* Append the triangles and images within `reach` [m] of x to the candidates, each once: of the walls
   with this reference frame (-1: at rest), x in that frame. */
int dem_wall_search_gather(struct dem_wall_search *, const struct dem_walls *, int frame,
                           const double x[3], double reach);

/* Move a sphere to where it touches the wall that it overlaps most, along the normal there. pushed:
   1 when it overlapped one; walls that move are left out. The wall neighbors found before are
   kept. */
int dem_wall_search_push_out(struct dem_wall_search *, const struct dem_walls *,
                             struct dem_particle *, int *pushed);

/* Before walls hold other triangles: wall neighbors name triangles and facets by index among all
   ranks, and number; after it, if those are still held: by index among those held. */
void dem_wall_search_use_indices(struct dem_wall_search *, const struct dem_walls *);
void dem_wall_search_use_held(struct dem_wall_search *, const struct dem_walls *);

/* Distance [m] of a point x, in the global frame, from the facet of a wall neighbor as contacts use
   it: negative behind a facet with one side. */
double dem_wall_search_distance(const struct dem_wall_search *, const struct dem_walls *,
                                const struct dem_wall_neighbor *, const double x[3]);

/* The point nearest to x of the triangles of a wall neighbor, both in the wall's frame, and the vector
   from there to x. Returns the distance [m]. */
double dem_wall_search_nearest(const struct dem_wall_search *, const struct dem_walls *,
                               const struct dem_wall_neighbor *, const double x[3],
                               double point[3], double away[3]);

/* A position in the wall's frame as seen from the facet of a wall neighbor, and from a candidate: x
   itself, or written to `moved`. */
static inline const double *dem_wall_from_facet(const struct dem_walls *w,
                                                const struct dem_wall_neighbor *near,
                                                const double x[3], double moved[3])
{
    return near->image[0] | near->image[1] | near->image[2]
               ? dem_walls_from_image(dem_walls_period(w, w->wall[w->facet[near->facet].wall].frame),
                                      near->image, x, moved)
               : x;
}

static inline const double *dem_wall_from_candidate(const struct dem_wall_search *s,
                                                    const struct dem_walls *w, uint32_t candidate,
                                                    const double x[3], double moved[3])
{
    return s->image ? dem_walls_from_image(
                          dem_walls_period(
                              w, w->wall[w->triangle[s->candidate[candidate]].wall].frame),
                          s->image[candidate].n, x, moved)
                    : x;
}

/* 1 when the contact is with the unbounded surface; not when the facet has become bent since the
   search. */
static inline int dem_wall_neighbor_open(const struct dem_walls *w,
                                         const struct dem_wall_neighbor *near)
{
    return near->open && !w->facet[near->facet].bent;
}

/* The candidate of a wall neighbor that is nearest to x, the first of equally near ones. */
uint32_t dem_wall_neighbor_candidate(const struct dem_wall_search *, const struct dem_walls *,
                                    const struct dem_wall_neighbor *, const double x[3]);

/* The point of a triangle nearest to x. Returns the squared distance [m2]. */
static inline double dem_triangle_nearest(const struct dem_triangle *t, const double x[3],
                                          double nearest[3])
{
    return dem_corners_nearest(t->corner, x, nearest);
}
