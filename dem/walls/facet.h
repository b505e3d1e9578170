/*
 * facet.h -- a facet of a wall, and the height of a point over its unbounded surface: plane, cylinder
 * or sphere. Devices compile it, too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/vec.h"

enum dem_shape
{
    DEM_SHAPE_TRIANGLES,
    DEM_SHAPE_PLANE,
    DEM_SHAPE_CYLINDER,           /* without ends */
    DEM_SHAPE_SPHERE
};

struct dem_facet                  /* in the wall's frame */
{
    /* unit, m: n.x = offset on the plane; n of a cylinder: its axis */
    double normal[3], offset;
    /* m: of a cylinder (any point of its axis) or sphere */
    double centre[3], radius;
    int wall, outside;
    enum dem_shape shape;
    /* among the facets of all ranks: the key of its contacts */
    int number;
    /* 1: it follows a mesh and is no longer plane */
    uint16_t bent;
    /* bit k: along axis k it is joined to its own periodic image */
    uint8_t endless;
    /* bit k: along axis k a particle may touch two of its images */
    uint8_t distinct;
    /* `index` of the largest triangle of the surface given, whose plane the facet has */
    uint32_t largest;
};

/* Height [m] of x, in the wall's frame, over the unbounded surface of a facet, negative behind it,
   and the unit normal there. */
DEM_MATH double dem_facet_height(const struct dem_facet *r, const double x[3], double normal[3])
{
    double d[3], size;

    if (r->shape == DEM_SHAPE_PLANE || r->shape == DEM_SHAPE_TRIANGLES)
    {
        for (int k = 0; k < 3; k++)
        {
            normal[k] = r->normal[k];
        }
        return dem_vec_dot(r->normal, x) - r->offset;
    }
    dem_vec_minus(x, r->centre, d);
    if (r->shape == DEM_SHAPE_CYLINDER)
    {
        const double along = dem_vec_dot(d, r->normal);

        for (int k = 0; k < 3; k++)
        {
            d[k] -= along*r->normal[k];
        }
    }
    size = dem_vec_norm(d);
    for (int k = 0; k < 3; k++)
    {
        /* on the axis the normal is arbitrary but must be the same on all ranks; no contact is
           there */
        normal[k] = size > 0.0 ? (r->outside ? d[k] : -d[k])/size : r->normal[(k + 1)%3];
    }
    return r->outside ? size - r->radius : r->radius - size;
}

/* Contact of a particle at x with the whole plane or curved surface of a facet, which sees the
   particle at `from`; both in the wall's frame. Triangles have two sides, all other shapes one. Sets
   the point [m] and the unit vector from there to the particle; returns the distance [m]. */
DEM_MATH double dem_facet_touch(const struct dem_facet *r, const double from[3], const double x[3],
                                double point[3], double normal[3])
{
    const double h = dem_facet_height(r, from, normal);
    const double side = r->shape != DEM_SHAPE_TRIANGLES || h >= 0.0 ? 1.0 : -1.0;

    for (int k = 0; k < 3; k++)
    {
        point[k] = x[k] - h*normal[k];
        normal[k] = side*normal[k];
    }
    return side*h;
}
