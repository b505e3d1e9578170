/*
 * mouth.h -- where a stream of particles comes in: anywhere in a region, or through a face.
 *
 *     min (0 0 0.1); max (0.1 0.1 0.2);                             a box
 *     cylinder { from; to; radius; }   sphere { centre; radius; }   as in vessel.h
 *     disc { centre (0 0 0.1); normal (0 0 -1); radius 0.02; }      a face
 *     surface "inlet.stl"; scale 1e-3;                              triangles of a file
 *     patch inlet;                                                  triangles of a mesh, handed in by the program
 *
 * In a region the sphere lies whole; on a face lies its centre. Who comes through a face has been on the way since some moment between two
 * looks, so that a stream has no layers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_MOUTH_H
#define DEM_IO_MOUTH_H

#include "io/vessel.h"

enum dem_mouth_kind
{
    DEM_MOUTH_REGION,
    DEM_MOUTH_DISC,
    DEM_MOUTH_FACES
};

struct dem_mouth
{
    enum dem_mouth_kind kind;
    struct dem_vessel vessel;                             /* of a region; a disc has its centre, sides and radius */
    const char *patch;                                    /* NULL: of no mesh */
    size_t n;                                             /* triangles, sorted, so that it does not matter who handed them in */
    double (*corner)[3][3];                               /* m */
    double (*flow)[3];                                    /* m/s  the fluid's velocity there; NULL: nobody told */
    double *below;                                        /* m2  area of the triangles up to and with each */
};

/* Exactly one of them. The file is read; a patch has no triangles yet. `where` starts messages. Free it also after a failure. */
int dem_mouth_read(struct dem_mouth *, const struct dem_dict *group, const char *where);
void dem_mouth_free(struct dem_mouth *);

/* Triangles, 9 numbers each [m], and the velocity of the fluid there, 3 each [m/s], or NULL; in any order. */
int dem_mouth_take(struct dem_mouth *, size_t n, const double *corners, const double *flow);

/* Refuse one that lies outside a box, or does not hold a sphere of this radius [m]. */
int dem_mouth_holds(const struct dem_mouth *, double radius, const char *where);

/* The box around all places of centres [m]. */
void dem_mouth_box(const struct dem_mouth *, double min[3], double max[3]);

/* A place for a centre when u is even in [0, 1)^3; `triangle`: of faces, the one that it is on. 0: draw another u. */
int dem_mouth_place(const struct dem_mouth *, double radius, const double u[3], double x[3], size_t *triangle);

/* The unit vector into the mesh at a triangle of a patch, whose corners go counterclockwise as seen from outside; else zero. */
void dem_mouth_inward(const struct dem_mouth *, size_t triangle, double inward[3]);

double dem_mouth_area(const struct dem_mouth *);          /* m2  of a face; 0 of a region */

#endif
