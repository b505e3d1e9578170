/*
 * spots.h -- places of spheres that are being packed, each on the rank in whose piece of space it lies, with copies for the others.
 *
 * Chains of spots by cell, one grid for each octave of diameters: pairs of any size are found in the grid of the larger one.
 * Not here: what is done with them (packing_places.c, packing_push.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_SPOTS_H
#define DEM_IO_SPOTS_H

#include "space/mail.h"
#include "space/pieces.h"
#include <stdint.h>

enum
{
    DEM_SPOT_LEVELS = 12                                  /* octaves of diameters, the last holds all that is smaller */
};

static const uint32_t dem_spot_none = UINT32_MAX;         /* ends a chain */

struct dem_spot                                           /* 64 bytes, a cache line */
{
    double x[3], radius;                                  /* m */
    double v[3];                                          /* m: of the last sweep; while places are tried v[0] is 1: here, 0: a copy */
    int64_t name;                                         /* number in its group; -1: it was there before and stays */
};

struct dem_spot_level
{
    double edge, most;                                    /* m: of a cell, largest radius of all ranks; 0: nobody */
    int64_t cells[3];
    size_t first;                                         /* of its cells among all */
};

struct dem_spot_post                                      /* a spot on its way to another rank */
{
    int peer, what;                                       /* what: the sender's word, handed to the receiver */
    struct dem_spot spot;
};

struct dem_spots
{
    struct dem_pieces pieces;
    double (*box)[2][3];                                  /* m: of each rank */
    double low[3], high[3];                               /* m: what the grids of this rank cover; who is outside is at their rim */
    struct dem_spot_level level[DEM_SPOT_LEVELS];
    double most;                                          /* m: largest radius of all */
    size_t cells, head_room;
    uint32_t *head, *next;                                /* by cell; by spot */
    size_t own, n, room, next_room;                       /* in pushing: own spots first, then copies */
    struct dem_spot *spot;
    size_t posts, post_room;
    struct dem_spot_post *post;
    struct dem_mail out, in;
};

int dem_spots_init(struct dem_spots *, const struct dem_pieces *of);
void dem_spots_free(struct dem_spots *);

/* Collective. Share the n places out among ranks, and learn the boxes. `low` and `high`: of the vessel. */
int dem_spots_share(struct dem_spots *, size_t n, const struct dem_spot *, const double low[3], const double high[3]);

/* The octave of a radius, and who has the largest of it. */
int dem_spots_level(const struct dem_spots *, double radius);
void dem_spots_admit(struct dem_spots *, double radius);

/* Empty grids, whose cells are wider than a diameter by `skin`, and so few that they suit a number of spots. */
int dem_spots_grid(struct dem_spots *, double skin, size_t spots);

int dem_spots_add(struct dem_spots *, const struct dem_spot *);
int dem_spots_enter(struct dem_spots *, uint32_t spot);   /* into its chain */

/* Post a spot to its owner, if that is another rank: then it is gone. And to all others within `reach` [m] of it, maybe to
   oneself. */
int dem_spots_send(struct dem_spots *, const struct dem_spot *, int what, int *gone);
int dem_spots_copy(struct dem_spots *, const struct dem_spot *, int what, double reach);

/* Collective. Deliver; what has come is in post[0 .. posts), in the order of the ranks that sent it. */
int dem_spots_deliver(struct dem_spots *);

static inline int64_t dem_spots_cell_on(const struct dem_spots *s, const struct dem_spot_level *l, int axis, double x)
{
    const double at = (x - s->low[axis])/l->edge;

    return !(at > 0.0) ? 0 : at >= (double)l->cells[axis] ? l->cells[axis] - 1 : (int64_t)at;
}

static inline size_t dem_spots_cell(const struct dem_spots *s, const struct dem_spot_level *l, const double x[3])
{
    return l->first + (size_t)((dem_spots_cell_on(s, l, 2, x[2])*l->cells[1] + dem_spots_cell_on(s, l, 1, x[1]))*l->cells[0]
                               + dem_spots_cell_on(s, l, 0, x[0]));
}

struct dem_spot_range                                     /* of cells */
{
    int64_t from[3], to[3];
};

static inline struct dem_spot_range dem_spots_range(const struct dem_spots *s, const struct dem_spot_level *l, const double x[3], double reach)
{
    struct dem_spot_range r;

    for (int k = 0; k < 3; k++)
    {
        r.from[k] = dem_spots_cell_on(s, l, k, x[k] - reach);
        r.to[k] = dem_spots_cell_on(s, l, k, x[k] + reach);
    }
    return r;
}

#endif
