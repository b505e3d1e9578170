/*
 * domain.h -- the box that particles live in: which axes are periodic, and what a shift by whole boxes means.
 *
 * Particles keep true coordinates; the shift of a periodic pair belongs to the pair, so that every rank computes
 * r = (x_i - x_j) + shift L with the same bits. An axis that is neither periodic nor bounded has infinite limits.
 *
 * Along a periodic axis positions, steps and the length of the box are whole multiples of a small power of two, about 1e-16 of the
 * largest coordinate: then all sums of them are exact, and nothing depends on when a particle is brought back into the box.
 *
 * A flat axis leaves two dimensions: centres stay in the middle plane of its limits, without velocity across it and without spin out
 * of it. Spheres are spheres nevertheless. The drift across it rounds to whole multiples of 1e284 m, which is none.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_SPACE_DOMAIN_H
#define DEM_SPACE_DOMAIN_H

#include "state/image.h"
#include "state/particles.h"
#include "state/walls.h"
#include <stdalign.h>

struct dem_domain
{
    double min[3], max[3];                                /* m; infinite where open */
    double length[3];                                     /* m; of periodic axes, else 0 */
    double unit[3];                                       /* m: positions along periodic axes are multiples of it */
    alignas(16) double round[4];                          /* m: (x + round) - round is the next multiple; 0 along other axes, and last */
    int periodic[3];
    int flat[3];
    double plane[3];                                      /* m; of flat axes: where centres are */
    int remove;                                           /* 1: a particle that leaves is removed, 0: it is an error */
};

void dem_domain_init(struct dem_domain *);                /* open everywhere */

/* When limits are known. Of periodic axes: the length, and what positions are multiples of; of flat ones: the plane. */
void dem_domain_close(struct dem_domain *);

/* The vector [m] of each code, 27 x 4, the last is 0; zero along axes that are not periodic. */
void dem_domain_shifts(const struct dem_domain *, double shift[DEM_SHIFTS][4]);

/* Bring a particle back into the box along periodic axes, counting its image, and to the next multiple there. */
void dem_domain_wrap(const struct dem_domain *, struct dem_particle *);

/* Put a centre into the planes of flat axes, without velocity across them; 0 when it is further off than the radius. */
int dem_domain_lay(const struct dem_domain *, struct dem_particle *);

/* All of them; refuse who is further off, or moves across. */
int dem_domain_lay_all(const struct dem_domain *, struct dem_particles *);

/* Take what particles have of velocity across flat axes and of spin out of the plane. */
void dem_domain_hold(const struct dem_domain *, struct dem_particles *);

/* Walls have no periodic images, so one that meets a periodic face must run straight through it; refuse any other, where a
   particle of this radius would pass the face and find itself in a wall. Walls stand as they do now. */
int dem_domain_check_walls(const struct dem_domain *, const struct dem_walls *, double radius);

/* 1 when the position is inside, or the axis is open or periodic (and the position not a thousand boxes away). */
int dem_domain_holds(const struct dem_domain *, const double x[3]);

#endif
