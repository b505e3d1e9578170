/*
 * displacement.h -- displacement of particles since a neighbor list was made, relative to their
 * common displacement.
 *
 *   d_i = x_i(now) - x_i(list)      c: any vector that all ranks agree on      s = max |d_i - c|
 *
 * The gap of two particles shrinks by at most 2 s, the gap of a particle and a wall by at most s +
 * |w - c|, w being the displacement of the wall (normal to it). A list that holds all pairs up to a
 * skin is valid until one of these exceeds the skin. The middle between the largest and the
 * smallest d_i along each axis makes s nearly as small as possible: zero for a bed that moves as a
 * whole, half the displacement when one particle flies and the others rest. Along an axis on which
 * particles can leave the domain c is zero, otherwise leaving particles would not be detected.
 *
 * Reference positions are stored as integers modulo 2^32 of a unit below 1e-4 of the skin: 12 bytes
 * per particle, valid up to 2^35 skins from the origin.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/particles.h"

enum
{
    DEM_DISPLACEMENT_NUMBERS = 7         /* extent: max and -min per axis, largest norm */
};

struct dem_displacement
{
    double skin;                  /* m */
    double spread;                /* m: upper bound of s; each step adds the largest speed times
                                     dt */
    double centre[3];             /* m: c */
    double unit, round;           /* m; the lowest 32 bits of (x + round) are x in units */
    uint32_t *reference;          /* reference positions, 3 per owned particle */
    size_t capacity;
    /* of a periodic domain that deforms (particles/cell.h): 1; the factors from present positions to those
       when the list was made, from the faces `origin` [m] on; x over y of its sheared edge, now and
       then; and the largest strain since then: pairs at a distance r come closer by strain r
       besides 2 s */
    int deforms;
    double back[3], origin[3], slant[2], strain;
};

void dem_displacement_free(struct dem_displacement *);
size_t dem_displacement_bytes(const struct dem_displacement *);

/* Take the present positions as reference of a list that is made now with this skin [m]. */
int dem_displacement_begin(struct dem_displacement *, const struct dem_particles *, double skin);

/* Extent of the displacements of this rank's particles: max d, max -d per axis, max |d| [m]. The
   caller takes the maximum of all ranks. */
void dem_displacement_extent(const struct dem_displacement *, const struct dem_particles *,
                             double extent[DEM_DISPLACEMENT_NUMBERS]);

/* From the extent of all ranks: set the bound for c = 0. Returns 1 when another c, written to
   `centre`, may give a smaller bound; it is zero along axes that are not `free`. */
int dem_displacement_set_extent(struct dem_displacement *,
                                const double extent[DEM_DISPLACEMENT_NUMBERS], const int free[3],
                                double centre[3]);

/* max |d - c| [m] of this rank's particles. */
double dem_displacement_spread(const struct dem_displacement *, const struct dem_particles *,
                               const double centre[3]);

/* Set the bound and the centre that it belongs to, equal on all ranks. */
void dem_displacement_set(struct dem_displacement *, double spread, const double centre[3]);
