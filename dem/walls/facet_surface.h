/*
 * facet_surface.h -- curvature of a facet at a contact, and its normal half a step ago, as the
 * particle saw it: wall_surface.h has the formulas. Devices compile it, too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "walls/facet.h"
#include "walls/pose.h"

/* R* [m] of a particle of this radius. A hollow wall too narrow for it is treated as wider by a
   thousandth. */
DEM_MATH double dem_facet_reduced_radius(const struct dem_facet *r, double radius)
{
    const double ratio = radius/r->radius, min_clearance = 1e-3,
                 bend = r->outside ? 1.0 + ratio : fmax(1.0 - ratio, min_clearance);

    return r->shape == DEM_SHAPE_SPHERE     ? radius/bend
           : r->shape == DEM_SHAPE_CYLINDER ? radius/sqrt(bend)
                                            : radius;
}

struct dem_facet_step    /* what has happened at a contact in the last step */
{
    const struct dem_wall_displacement *displacement;    /* of the wall */
    const struct dem_pose *pose;                         /* of its frame; NULL: at rest */
    double v[3], dt;                                     /* m/s of the particle, s */
};

/* The normal a step ago: of a plane or facet in its orientation then, of a curved wall at the
   particle's position then. `back`: the displacement [m] of the particle relative to the wall. */
DEM_MATH void dem_facet_normal_before(const struct dem_facet *r,
                                      const struct dem_wall_displacement *s, const double back[3],
                                      const double normal[3], double distance, double before[3])
{
    double d[3];

    if (r->shape == DEM_SHAPE_PLANE || r->shape == DEM_SHAPE_TRIANGLES)
    {
        dem_wall_displacement_rotate_back(s, normal, before);
        return;
    }
    /* the particle's distance from the axis or the centre */
    const double reach = r->outside ? r->radius + distance : r->radius - distance;
    double along = 0.0;

    for (int k = 0; k < 3; k++)
    {
        d[k] = (r->outside ? reach : -reach)*normal[k] - back[k];
    }
    for (int k = 0; k < 3 && r->shape == DEM_SHAPE_CYLINDER; k++)
    {
        along += d[k]*r->normal[k];
    }
    const double size = sqrt(fmax(dem_vec_dot(d, d) - along*along, 0.0));

    for (int k = 0; k < 3; k++)
    {
        const double flat = d[k] - (r->shape == DEM_SHAPE_CYLINDER ? along*r->normal[k] : 0.0);

        before[k] = size > 0.0 ? (r->outside ? flat : -flat)/size : normal[k];
    }
}

/* The unit normal half a step ago of a contact with this normal and distance [m] now. */
DEM_MATH void dem_facet_normal_half_step(const struct dem_facet *r, const struct dem_facet_step *s,
                                         const double normal[3], double distance, double half_step[3])
{
    double back[3], before[3], centre[3] = {0.0, 0.0, 0.0};

    if (r->shape == DEM_SHAPE_CYLINDER || r->shape == DEM_SHAPE_SPHERE)
    {
        for (int k = 0; k < 3; k++)
        {
            centre[k] = r->centre[k];
        }
        if (s->pose)
        {
            dem_pose_point(s->pose, r->centre, centre);
        }
        dem_wall_displacement_velocity(s->displacement, centre, centre);
    }
    for (int k = 0; k < 3; k++)
    {
        back[k] = s->dt*(s->v[k] - centre[k]);
    }
    dem_facet_normal_before(r, s->displacement, back, normal, distance, before);
    for (int k = 0; k < 3; k++)
    {
        half_step[k] = normal[k] + before[k];
    }
    const double size = dem_vec_norm(half_step);

    for (int k = 0; k < 3; k++)
    {
        half_step[k] = size > 0.0 ? half_step[k]/size : normal[k];
    }
}
