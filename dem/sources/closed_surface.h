/*
 * closed_surface.h -- whether a point lies inside a closed surface of triangles: of a mesh, of
 * one of its zones or of a wall.
 *
 * Inside: a ray from the point crosses the surface an odd number of times. The ray has a fixed
 * direction that no mesh is aligned with. Whether it crosses an edge to the left or to the right is
 * computed from the sorted ends of the edge, so triangles that share an edge agree, and the answer
 * does not depend on the order of the triangles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "walls/walls.h"
#include <stddef.h>
#include <stdint.h>

struct dem_closed_surface
{
    char name[64];
    const char *what;            /* "mesh", "zone" or "wall", for messages */
    int zone;                    /* 1: of a zone of the mesh */
    size_t n;
    double (*corner)[3][3];      /* m */
    double min[3], max[3];       /* m  bounding box */
    double volume;               /* m3 inside */
    double low[2], edge[2];      /* m  of the grid across the ray */
    int cells[2];
    size_t *start;               /* of the triangles of each cell in `entry` */
    uint32_t *entry;
};

/* Take n triangles, 9 numbers each [m], corners counterclockwise as seen from outside, or all
   clockwise. The array belongs to the surface from then on, also after a failure. */
int dem_closed_surface_init(struct dem_closed_surface *, size_t n, double *corners);
/* The same with the triangles of a wall. Walls that are not finished have them as the scene gives them. */
int dem_closed_surface_of_wall(struct dem_closed_surface *, const struct dem_walls *, int wall);
void dem_closed_surface_free(struct dem_closed_surface *);

/* Centroid [m] and tensor of inertia about it, over the density [m5], of the volume inside. */
void dem_closed_surface_inertia(const struct dem_closed_surface *, double centre[3],
                                double inertia[3][3]);

int dem_closed_surface_contains(const struct dem_closed_surface *, const double x[3]);
