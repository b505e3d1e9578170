/*
 * packing_pairs.h -- list of near pairs of spheres that are being packed, for any range of sizes,
 * on all ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_INSERTION_PACKING_PAIRS_H
#define DEM_INSERTION_PACKING_PAIRS_H

#include "insertion/placed_sphere.h"

struct dem_packing_pair
{
    uint32_t a, b;  /* spheres, at least one of them owned */
};

/* position and radius, packed for the distance test */
struct dem_packed_sphere
{
    double x[3], radius;  /* m */
};

struct dem_packing_pairs
{
    struct dem_placed_spheres *s;
    double skin, stretch;              /* m, 1  pairs nearer than stretch (R_i + R_j) + skin are
                                          listed */
    size_t n, capacity, place_capacity, fixed_capacity, order_capacity, start_capacity, sent;
    size_t sent_capacity;
    struct dem_packing_pair *pair;
    struct dem_packed_sphere *packed;  /* of each sphere; to be updated together with it */
    uint8_t *fixed;                    /* 1: of an earlier group, does not move */
    struct dem_placed_sphere *order;   /* scratch for sorting */
    uint32_t *start;                   /* the first owned sphere of each cell */
    struct sent *send;                 /* ghosts to be updated on other ranks */
};

/* Collective. Send spheres to their owners and ghosts to others, and list the pairs. Two fixed
   spheres are no pair. */
int dem_packing_pairs_list(struct dem_packing_pairs *);

/* Collective. Update the positions of the ghosts. */
int dem_packing_pairs_refresh(struct dem_packing_pairs *);

void dem_packing_pairs_free(struct dem_packing_pairs *);

#endif
