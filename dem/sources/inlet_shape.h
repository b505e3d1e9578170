/*
 * inlet_shape.h -- inlet of a stream of particles: a region of space, or a face.
 *
 *     min (0 0 0.1); max (0.1 0.1 0.2);                          a box
 *     cylinder { from; to; radius; } sphere { centre; radius; }  as in insertion_shape.h
 *     disc { centre (0 0 0.1); normal (0 0 -1); radius 0.02; }   a face
 *     surface "inlet.stl"; scale 1e-3;                           triangles of a file
 *     patch inlet;                                               triangles of a mesh, supplied by
 *                                                                the program
 *
 * In a region the whole sphere lies inside, except at periodic faces; on a face its centre lies on
 * the face. A particle that enters through a face has been moving since a random time between two
 * checks, so that the stream has no layers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "sources/insertion_shape.h"

enum dem_inlet_shape_kind
{
    DEM_INLET_REGION,
    DEM_INLET_DISC,
    DEM_INLET_FACES
};

struct dem_inlet_shape
{
    enum dem_inlet_shape_kind kind;
    struct dem_insertion_shape shape;  /* region; of a disc only centre, sides and radius */
    const char *patch;                  /* name of the patch; NULL: not a patch */
    size_t n;                           /* triangles, sorted, so that their
                                           order on input does not matter */
    double (*corner)[3][3];             /* m */
    double (*flow)[3];                  /* m/s  velocity of the fluid
                                           there; 0 if it was not given */
    double *cumulative_area;            /* m2  cumulative area of the triangles */
};

/* Read exactly one of these shapes. A file is read; a patch has no triangles yet. `where` starts
   messages. To be freed also after a failure. */
int dem_inlet_shape_read(struct dem_inlet_shape *, const struct dem_dict *group, const char *where);
void dem_inlet_shape_free(struct dem_inlet_shape *);

/* Set the triangles, 9 numbers each [m], and the velocity of the fluid there, 3 each [m/s], or
   NULL; in any order. The arrays are copied. */
int dem_inlet_shape_set_triangles(struct dem_inlet_shape *, size_t n, const double *corners,
                                  const double *flow);

/* Open the sides of a region on periodic faces. Refuse one that overlaps its own image or cannot
   hold a sphere of this radius [m]. */
int dem_inlet_shape_check(struct dem_inlet_shape *, const struct dem_domain *, double radius,
                          const char *where);

/* Bounding box of all positions of centres [m]. */
void dem_inlet_shape_bounds(const struct dem_inlet_shape *, double min[3], double max[3]);

/* A position of a centre, uniformly distributed for u uniform in [0, 1)^3; `triangle`: of a face,
   the one it lies on. Returns 0 when this u gives no position: draw another one. */
int dem_inlet_shape_draw(const struct dem_inlet_shape *, double radius, const double u[3],
                         double x[3], size_t *triangle);

/* Unit vector into the mesh at a triangle of a patch, whose corners go counterclockwise as seen
   from outside; otherwise zero. */
void dem_inlet_shape_inward(const struct dem_inlet_shape *, size_t triangle, double inward[3]);

double dem_inlet_shape_area(const struct dem_inlet_shape *);    /* m2  of a face; 0 of a region */
