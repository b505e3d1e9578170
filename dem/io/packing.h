/*
 * packing.h -- spheres at random in a vessel, without overlap, among spheres that are there already.
 *
 * Each is tried at random places, the largest first (random sequential addition). One that finds none in some trials is
 * put where it was last and makes room: spheres that overlap push each other apart, again and again, until none do.
 * Random addition alone ends near a solid fraction of 0.3; pushing goes on to 0.55 and more.
 *
 * Pushing: Gauss-Seidel projection of the constraints |r_ij| >= R_i + R_j, each pair in turn moved apart by halves, as in
 * Jodrey and Tory, Phys. Rev. A 32 (1985) 2347, but at fixed radii and only where spheres overlap.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_PACKING_H
#define DEM_IO_PACKING_H

#include "io/crowd.h"
#include "io/vessel.h"

struct dem_packing                                        /* what to pack */
{
    const struct dem_vessel *vessel;
    const char *where;                                    /* starts messages */
    uint64_t seed;
    int32_t n;
    const double *diameter;                               /* m */
    double (*x)[3];                                       /* m  out: centres */
};

/* Refuse n spheres of this volume [m3] in all, if no packing at random is so dense. */
int dem_packing_may_fit(const struct dem_vessel *, double volume, double n, const char *where);

/* For spheres that may fit, each no wider than the vessel. Does not touch the crowd: its spheres stay where they are. */
int dem_packing_fill(struct dem_packing *, const struct dem_crowd *);

#endif
