/*
 * insertion_shape.h -- the region into which particles are inserted: a box, a cylinder or a sphere.
 *
 *     min (0 0 0); max (0.1 0.1 0.2);
 *     cylinder { from (0 0 0); to (0 0 0.2); radius 0.05; }
 *     sphere   { centre (0 0 0); radius 0.05; }
 *
 * Spheres lie wholly inside, except at periodic faces of the domain: a side of a box, or an end of
 * a cylinder, on such a face is open. Centres lie up to the face there, and spheres reach through.
 * A shape as wide as the domain along a periodic axis is open at both sides, wherever these are.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "input/dictionary.h"
#include "particles/domain.h"

struct dem_insertion_limits;

enum dem_insertion_shape_kind
{
    DEM_INSERTION_SHAPE_BOX,
    DEM_INSERTION_SHAPE_CYLINDER,
    DEM_INSERTION_SHAPE_SPHERE
};

struct dem_insertion_shape
{
    enum dem_insertion_shape_kind kind;
    double min[3], max[3];                /* m  the box, or the bounding box */
    double from[3], axis[3], side[2][3];  /* m, 1, 1  of a cylinder: base, unit vectors; of a
                                             sphere: centre */
    double length, radius;                /* m */
    double period[3];                     /* m  width of a periodic domain along an axis, else 0 */
    int open[3][2], open_end[2];          /* 1: on a periodic face or flat (min = max): sides of a
                                             box, ends of a cylinder */
    struct dem_insertion_limits *limits;  /* further limits, which belong to the group, or NULL */
    double region;                        /* m3  of the whole mesh or zone, when that is the shape, or
                                             before it became flat; 0: of the box, cylinder or sphere */
};

/* Read the shape of a group. An error unless exactly one of the three is given. */
int dem_insertion_shape_read(struct dem_insertion_shape *, const struct dem_dict *group);

/* Open the sides on periodic faces of the domain. An error when the shape is wider than the domain
   along a periodic axis, so that it overlaps its own image. `where` starts the message. */
int dem_insertion_shape_open(struct dem_insertion_shape *, const struct dem_domain *,
                             const char *where);

double dem_insertion_shape_volume(const struct dem_insertion_shape *);    /* m3 */

/* "box", "cylinder" or "sphere" */
const char *dem_insertion_shape_name(const struct dem_insertion_shape *);

/* An error when a sphere of this radius [m] does not fit into the shape. `where` starts the
   message. */
int dem_insertion_shape_check_fits(const struct dem_insertion_shape *, double radius,
                                   const char *where);

/* A centre x [m] for a sphere of this radius inside the shape, uniformly distributed when u is
   so in [0, 1)^3. Returns 0 when another u has to be drawn. */
int dem_insertion_shape_draw(const struct dem_insertion_shape *, double radius, const double u[3],
                             double x[3]);

/* 1 when a point is inside. */
int dem_insertion_shape_contains(const struct dem_insertion_shape *, const double x[3]);

/* 1 when any point of the path from + t step, t in part[0] .. part[1] within 0 .. 1, is inside. */
int dem_insertion_shape_meets(const struct dem_insertion_shape *, const double from[3],
                              const double step[3], const double part[2]);

/* Shorten `part` of the path at + t step, t in 0 .. 1, to where it is in low .. high. Returns 0 when
   nothing is left. */
int dem_insertion_shape_clip(double at, double step, double low, double high, double part[2]);

/* Set `side`: two unit vectors normal to the axis and to each other. */
void dem_insertion_shape_sides(struct dem_insertion_shape *);

/* Move a centre to the nearest position at which a sphere of this radius lies inside the shape, or
   inside the image of the shape nearest to the centre. */
void dem_insertion_shape_confine(const struct dem_insertion_shape *, double radius, double x[3]);
