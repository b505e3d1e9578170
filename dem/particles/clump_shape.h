/*
 * clump_shape.h -- templates of rigid bodies: the entry `shapes` of a scene.
 *
 *     shapes { nut { spheres ((0 0 0 1e-3) (1e-3 0 0 1e-3)); } }      x y z r of each sphere [m]
 *
 * The body is the union of its spheres: what several of them hold counts once. Volume, centre and
 * inertia are sums in closed form where no two spheres overlap; else integrals over columns along
 * z, the midpoints of a grid of 1024 x 1024 on the x-y face of the bounding box: exact along z, and to
 * 1e-6 across. Multiplied by the density of the material of a group they are mass and inertia.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_PARTICLES_CLUMP_SHAPE_H
#define DEM_PARTICLES_CLUMP_SHAPE_H

#include "input/dictionary.h"
#include "particles/particles.h"

struct dem_clump_shape
{
    const char *name;
    size_t n;
    const double (*sphere)[4];        /* x, y, z [m] in the axes of the scene, radius [m] */
    double (*offset)[3];              /* m  from the centre, in principal axes; owned */
    double volume, centre[3];         /* m3, m  of the union */
    double inertia[3];                /* m5  principal moments over the density */
    double principal[4];              /* quaternion from the principal axes to those of the scene */
    double solid;                     /* m3  sum of the volumes of the spheres */
    double bound, reach;              /* m  radius of the sphere around the centre that holds the
                                         body; largest offset */
};

struct dem_clump_shapes
{
    size_t n, capacity;
    struct dem_clump_shape *shape;
};

/* The entry shapes of a scene, which must outlive them. To be freed also after a failure. */
int dem_clump_shapes_read(struct dem_clump_shapes *, const struct dem_dict *scene);
void dem_clump_shapes_free(struct dem_clump_shapes *);

/* The shape with this name; an error that begins with `where` lists those that exist. */
int dem_clump_shapes_find(const struct dem_clump_shapes *, const char *name, const char *where,
                          const struct dem_clump_shape **);

#endif
