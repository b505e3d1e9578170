/*
 * packing_pairs.h -- who is near whom, of spheres that are being packed, through all sizes and on all ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_PACKING_PAIRS_H
#define DEM_IO_PACKING_PAIRS_H

#include "io/spots.h"

struct dem_packing_pair
{
    uint32_t a, b;                                        /* spots: own ones and copies, one of them an own one */
};

struct dem_place                                          /* what a distance needs, packed */
{
    double x[3], radius;                                  /* m */
};

struct dem_packing_pairs
{
    struct dem_spots *s;
    double skin, stretch;                                 /* m, 1: listed are those nearer than stretch (R_i + R_j) + skin */
    size_t n, room, place_room, fixed_room, order_room, start_room, sent, sent_room;
    struct dem_packing_pair *pair;
    struct dem_place *place;                              /* of each spot; who moves one moves both */
    uint8_t *fixed;                                       /* 1: was there before and stays */
    struct dem_spot *order;
    uint32_t *start;                                      /* the first own spot of each cell */
    struct sent *send;
};

/* Collective. Spots to their owners, copies, pairs. Two that stay are no pair. */
int dem_packing_pairs_list(struct dem_packing_pairs *);

/* Collective. Copies where their owners are now. */
int dem_packing_pairs_refresh(struct dem_packing_pairs *);

void dem_packing_pairs_free(struct dem_packing_pairs *);

#endif
