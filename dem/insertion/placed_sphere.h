/*
 * placed_sphere.h -- the spheres of a packing: each on the rank that owns its position, with ghosts
 * on other ranks.
 *
 * Linked cells, one grid for each octave of diameters: a pair of any sizes is found in the grid of
 * the larger sphere. The algorithms that use them are in packing_addition.c and packing_relax.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_INSERTION_PLACED_SPHERE_H
#define DEM_INSERTION_PLACED_SPHERE_H

#include "parallel/sparse_exchange.h"
#include "parallel/decomposition.h"
#include <stdint.h>

enum
{
    DEM_PLACED_SPHERE_LEVELS = 12  /* octaves of diameters; the last holds all smaller ones */
};

static const uint32_t dem_placed_sphere_none = UINT32_MAX;    /* ends a list of a cell */

/* a sphere of a packing; 64 bytes, a cache line */
struct dem_placed_sphere
{
    double x[3], radius;  /* m */
    double v[3];          /* m  displacement of the last sweep; in packing_addition.c v[0] is 1:
                             owned, 0: a ghost */
    int64_t number;       /* in its group; -1: of an earlier group, does not move */
};

struct dem_placed_sphere_level
{
    double edge, max_radius;  /* m  of a cell; largest radius on all ranks, 0: none */
    int64_t cells[3];
    size_t first;             /* the index of its first cell among those of all levels */
};

/* a sphere on its way to another rank */
struct dem_placed_sphere_message
{
    int peer, kind;  /* kind: a number that the caller defines, delivered with the sphere */
    struct dem_placed_sphere sphere;
};

struct dem_placed_spheres
{
    struct dem_decomposition decomposition;
    double (*box)[2][3];                       /* m  of each rank */
    double low[3], high[3];                    /* m  extent of this rank's grids; spheres outside
                                                  are in their outermost cells */
    struct dem_placed_sphere_level level[DEM_PLACED_SPHERE_LEVELS];
    double max_radius;                         /* m  largest radius of all */
    size_t cells, head_capacity;
    uint32_t *head, *next;                     /* linked cells: first of a cell, next of a sphere */
    size_t owned, n, capacity, next_capacity;  /* in relaxation: owned spheres first, then ghosts */
    struct dem_placed_sphere *sphere;
    size_t messages, message_capacity;
    struct dem_placed_sphere_message *message;
    struct dem_messages out, in;
};

int dem_placed_spheres_init(struct dem_placed_spheres *, const struct dem_decomposition *of);
void dem_placed_spheres_free(struct dem_placed_spheres *);

/* Collective. Decompose space by these n positions of each rank, and set the boxes. `low` and
   `high`: of the shape. */
int dem_placed_spheres_decompose(struct dem_placed_spheres *, size_t n,
                                 const struct dem_placed_sphere *, const double low[3],
                                 const double high[3]);

/* The octave of a radius; extend its largest radius by this one. */
int dem_placed_spheres_level(const struct dem_placed_spheres *, double radius);
void dem_placed_spheres_include_radius(struct dem_placed_spheres *, double radius);

/* Empty grids. Cells are at least a diameter and `skin` [m] wide, and their number is
   proportional to that of spheres. */
int dem_placed_spheres_clear_grids(struct dem_placed_spheres *, double skin, size_t spheres);

int dem_placed_spheres_add(struct dem_placed_spheres *, const struct dem_placed_sphere *);
/* into the list of its cell */
int dem_placed_spheres_link(struct dem_placed_spheres *, uint32_t sphere);

/* Queue a sphere for the rank that owns its position; *sent: 1 when that is another rank, and
   the caller drops the sphere. Queue a ghost for each rank but the owner within `reach` [m] of
   it, which may be this rank. */
int dem_placed_spheres_send_to_owner(struct dem_placed_spheres *, const struct dem_placed_sphere *,
                                     int kind, int *sent);
int dem_placed_spheres_send_ghosts(struct dem_placed_spheres *, const struct dem_placed_sphere *,
                                   int kind, double reach);

/* Collective. Exchange the queues; spheres received are in message[0 .. messages), in the order
   of the sending ranks. */
int dem_placed_spheres_exchange(struct dem_placed_spheres *);

static inline int64_t dem_placed_spheres_cell_along(const struct dem_placed_spheres *s,
                                                    const struct dem_placed_sphere_level *l,
                                                    int axis, double x)
{
    const double at = (x - s->low[axis])/l->edge;

    return !(at > 0.0) ? 0 : at >= (double)l->cells[axis] ? l->cells[axis] - 1 : (int64_t)at;
}

static inline size_t dem_placed_spheres_cell(const struct dem_placed_spheres *s,
                                             const struct dem_placed_sphere_level *l,
                                             const double x[3])
{
    return l->first
         + (size_t)((dem_placed_spheres_cell_along(s, l, 2, x[2])*l->cells[1]
                     + dem_placed_spheres_cell_along(s, l, 1, x[1]))
                        *l->cells[0]
                    + dem_placed_spheres_cell_along(s, l, 0, x[0]));
}

/* the first and the last cell along each axis */
struct dem_cell_range
{
    int64_t from[3], to[3];
};

static inline struct dem_cell_range
dem_placed_spheres_cell_range(const struct dem_placed_spheres *s,
                              const struct dem_placed_sphere_level *l, const double x[3],
                              double reach)
{
    struct dem_cell_range r;

    for (int k = 0; k < 3; k++)
    {
        r.from[k] = dem_placed_spheres_cell_along(s, l, k, x[k] - reach);
        r.to[k] = dem_placed_spheres_cell_along(s, l, k, x[k] + reach);
    }
    return r;
}

#endif
