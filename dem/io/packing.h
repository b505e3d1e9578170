/*
 * packing.h -- spheres at random in a vessel, without overlap, among spheres that are there already.
 *
 * First random places, the largest spheres first (random sequential addition, packing_places.c). Who finds none stays where he was
 * last and makes room: spheres that overlap push each other apart, all at once, again and again, until none do
 * (packing_push.c). Random addition alone ends near a solid fraction of 0.3; pushing goes on to 0.57.
 *
 * Each rank works in its piece of the vessel; the result is a function of the seed and the diameters, and the same to the last bit
 * on any number of ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_PACKING_H
#define DEM_IO_PACKING_H

#include "io/crowd.h"
#include "io/spots.h"
#include "io/vessel.h"

struct dem_packing                                        /* what to pack */
{
    const struct dem_vessel *vessel;
    const char *where;                                    /* starts messages */
    uint64_t seed;
    int64_t n;                                            /* of all ranks together */
    double diameter;                                      /* m  of all, unless there are diameters */
    const double *diameters;                              /* m  of each, or null */
};

/* Refuse n spheres of this volume [m3] in all, if no packing at random is so dense. */
int dem_packing_may_fit(const struct dem_vessel *, double volume, double n, const char *where);

/* Collective. For spheres that may fit, each no wider than the vessel. The crowds of the ranks stay where they are. What comes
   out are this rank's spots, in no order; those with a name below 0 were there before. */
int dem_packing_fill(const struct dem_packing *, const struct dem_crowd *, struct dem_spots *);

/* ---- its parts ------------------------------------------------------------------------------------------------- */

/* The `trial`-th place of a sphere. */
void dem_packing_draw(const struct dem_packing *, struct dem_spot *, uint64_t trial);

/* Collective. Random places for all that are not there yet; `left` tells how many overlap. */
int dem_packing_place(const struct dem_packing *, struct dem_spots *, int64_t *left);

/* Collective. Push apart until nobody overlaps. `width` [m]: a diameter in the mean. */
int dem_packing_push(const struct dem_packing *, struct dem_spots *, double width);

#endif
