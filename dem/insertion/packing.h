/*
 * packing.h -- random packing of spheres in an insertion shape, without overlap, also with the
 * spheres of earlier groups.
 *
 * 1. Random sequential addition, largest spheres first (packing_addition.c). It ends near a solid
 *    fraction of 0.3; a sphere that finds no free position stays at its last trial.
 * 2. Relaxation: overlapping spheres move apart, all at once, until no overlap is left
 *    (packing_relax.c), up to 0.57.
 *
 * Each rank works in its part of the shape. The result is a function of the seed and the diameters,
 * the same to the last bit on any number of ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_INSERTION_PACKING_H
#define DEM_INSERTION_PACKING_H

#include "insertion/initial_particles.h"
#include "insertion/placed_sphere.h"
#include "insertion/insertion_limits.h"
#include "insertion/insertion_shape.h"

/* the spheres to pack, and where */
struct dem_packing
{
    const struct dem_insertion_shape *shape;
    const char *where;        /* starts messages */
    uint64_t seed;
    int64_t n;                /* spheres of all ranks */
    double diameter;          /* m  of all, unless there are diameters */
    const double *diameters;  /* m  of each, or NULL */
};

/* An error when n spheres of this total volume [m3] are denser than a random packing can be.
   `where` starts the message. */
int dem_packing_check_fraction(const struct dem_insertion_shape *, double volume, double n,
                               const char *where);

/* Collective. Pack spheres for which dem_packing_check_fraction succeeds, each no wider than the
   shape, around the particles of earlier groups, which do not move. The results are the spheres in
   this rank's part, in no order; those with a number below 0 are of earlier groups. */
int dem_packing_fill(const struct dem_packing *, const struct dem_initial_particles *,
                     struct dem_placed_spheres *);

/* ---- steps of dem_packing_fill --------------------------------------------------------------- */

/* Set the position of a sphere to that of its `trial`-th trial. Returns 0 when the limits of the
   shape leave none. */
int dem_packing_draw(const struct dem_packing *, struct dem_placed_sphere *, uint64_t trial);

/* Collective. Place all new spheres at random; *left is the number of those that overlap. */
int dem_packing_place(const struct dem_packing *, struct dem_placed_spheres *, int64_t *left);

/* Collective. Move spheres apart until no overlap is left. `mean_diameter` [m] sets the skin of
   the pair list. */
int dem_packing_relax(const struct dem_packing *, struct dem_placed_spheres *,
                      double mean_diameter);

#endif
