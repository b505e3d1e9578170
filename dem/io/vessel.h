/*
 * vessel.h -- the region that a group of particles is put into: a box, a cylinder or a sphere.
 *
 *     min (0 0 0); max (0.1 0.1 0.2);
 *     cylinder { from (0 0 0); to (0 0 0.2); radius 0.05; }
 *     sphere   { centre (0 0 0); radius 0.05; }
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_VESSEL_H
#define DEM_IO_VESSEL_H

#include "io/dictionary.h"

enum dem_vessel_kind
{
    DEM_VESSEL_BOX,
    DEM_VESSEL_CYLINDER,
    DEM_VESSEL_SPHERE
};

struct dem_vessel
{
    enum dem_vessel_kind kind;
    double min[3], max[3];                                /* m  the box, or the one around it */
    double from[3], axis[3], side[2][3];                  /* m, 1  of a cylinder: foot, unit vectors; of a sphere: centre */
    double length, radius;                                /* m */
};

/* Exactly one of the three. */
int dem_vessel_read(struct dem_vessel *, const struct dem_dict *group);

double dem_vessel_volume(const struct dem_vessel *);      /* m3 */

const char *dem_vessel_name(const struct dem_vessel *);   /* box, cylinder, sphere */

/* Refuse a vessel that does not hold a sphere of this radius [m]. */
int dem_vessel_holds(const struct dem_vessel *, double radius, const char *where);

/* A place for the centre of a sphere of this radius, even in the vessel when u is even in [0, 1)^3; 0: draw another u. */
int dem_vessel_place(const struct dem_vessel *, double radius, const double u[3], double x[3]);

/* 1 when a point is inside. */
int dem_vessel_contains(const struct dem_vessel *, const double x[3]);

/* Two unit vectors across the axis. */
void dem_vessel_sides(struct dem_vessel *);

/* Bring a centre back to where its sphere lies in the vessel. */
void dem_vessel_confine(const struct dem_vessel *, double radius, double x[3]);

#endif
