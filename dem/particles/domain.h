/*
 * domain.h -- the simulation box: limits, periodic axes, flat axes (two dimensions).
 *
 * Particles keep their true coordinates. The shift of a periodic pair belongs to the pair, so that
 * every rank computes r = (x_i - x_j) + shift L with the same bits. An axis that is neither
 * periodic nor bounded has infinite limits.
 *
 * Along a periodic axis positions, displacements of a step and the length of the box are integer
 * multiples of a small power of two, about 1e-16 of the largest coordinate. All sums of them are
 * then exact, and results do not depend on when a particle is wrapped.
 *
 * A flat axis reduces the motion to two dimensions: centres stay in the middle plane of its limits,
 * without velocity across the plane and without spin out of it. Particles remain spheres. The drift
 * across the plane is rounded to multiples of 1e284 m, that is to zero.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/periodic_image.h"
#include "particles/particles.h"
#include <stdalign.h>

struct dem_domain
{
    double min[3], max[3];        /* m; infinite where open */
    double length[3];             /* m; of periodic axes, else 0 */
    double unit[3];               /* m: positions along periodic axes are multiples of it */
    alignas(16) double round[4];  /* m: (x + round) - round is the nearest multiple; 0 along other
                                     axes and in the last entry */
    int periodic[3];
    int flat[3];
    double offset;                /* m: along x, of the images across the faces of y (Lees and Edwards);
                                     a multiple of the unit; 0 but in a cell that is sheared */
    double plane[3];              /* m; position of the plane of flat axes */
    int remove;                   /* 1: particles that leave are removed, 0: an error */
};

void dem_domain_init(struct dem_domain *);                /* open everywhere */

/* Once the limits are set: compute length and unit of periodic axes and the plane of flat axes. */
void dem_domain_finish(struct dem_domain *);

/* 1 when a code shifts along periodic axes only. */
static inline int dem_domain_has_shift(const struct dem_domain *d, int code)
{
    return (d->periodic[0] || dem_shift_axis(code, 0) == 0) && (d->periodic[1] || dem_shift_axis(code, 1) == 0)
        && (d->periodic[2] || dem_shift_axis(code, 2) == 0);
}

/* The shift vector [m] of each code, 27 x 4, the fourth entry is 0; zero along axes that are not
   periodic. */
void dem_domain_shifts(const struct dem_domain *, double shift[DEM_SHIFTS][4]);

/* The whole lengths of x that the offset has reached: with so many less it is the nearest one. */
double dem_domain_offset_turns(const struct dem_domain *);

/* Wrap a particle into the box along periodic axes, update its image counter and round its position
   to the nearest multiple of the unit. */
void dem_domain_wrap(const struct dem_domain *, struct dem_particle *);

/* Project a particle onto the planes of flat axes: position, velocity, spin. Returns 0, and changes
   nothing, when the centre is further off than its radius; else 1. */
int dem_domain_project(const struct dem_domain *, struct dem_particle *);

/* The same for all owned particles. DEM_ERROR_INPUT when one is too far off or moves across the
   plane. */
int dem_domain_project_all(const struct dem_domain *, struct dem_particles *);

/* Set velocities across flat axes and spins out of the plane to zero. */
void dem_domain_constrain(const struct dem_domain *, struct dem_particles *);

/* 1 when the position lies inside along all bounded axes, and within 1024 boxes along periodic
   ones. */
int dem_domain_contains(const struct dem_domain *, const double x[3]);
