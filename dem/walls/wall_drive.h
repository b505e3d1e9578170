/*
 * wall_drive.h -- the velocity of a surface that slides in itself, like a conveyor belt. Devices compile
 * it, too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "walls/facet.h"
#include "walls/pose.h"

struct dem_wall_drive    /* in the wall's frame */
{
    double velocity[3];              /* m/s  of a belt */
    double spin[3], origin[3];       /* 1/s, m  of a solid that turns */
    double axis[3], speed;           /* unit, m/s  of a belt around an axis */
};

/* Add a belt's velocity along a face: `direction` projected on the face, with this speed [m/s]. A face
   has no direction of a belt that meets it at a smaller sine than 1e-3, above the error of the
   normals of an STL file in single precision. */
DEM_MATH void dem_wall_drive_along(const double direction[3], const double normal[3], double speed,
                                   double sum[3])
{
    const double across = dem_vec_dot(direction, normal), min_sine = 1e-3;
    double along[3];

    for (int k = 0; k < 3; k++)
    {
        along[k] = direction[k] - across*normal[k];
    }
    const double size = dem_vec_norm(along);

    for (int k = 0; k < 3 && size > min_sine*dem_vec_norm(direction); k++)
    {
        sum[k] += along[k]*(speed/size);
    }
}

/* Velocity of the surface in itself at the point x, both in the wall's frame: a belt in the
   direction V, a belt around an axis, a solid that turns:

     |V| unit(P V) + speed unit(P (axis x d)) + spin x d
     d = x - origin,  P v = v - (v.n) n

   n is the normal of the face also where the contact is on its edge, so a ball leaves the end of a
   belt with the velocity of the belt. */
DEM_MATH void dem_wall_drive_velocity(const struct dem_wall_drive *of, const struct dem_facet *r,
                                      const double x[3], const double contact_normal[3],
                                      double own[3])
{
    const double *const n =
        r->shape == DEM_SHAPE_TRIANGLES && !r->bent ? r->normal : contact_normal;
    double d[3], around[3];

    dem_vec_minus(x, of->origin, d);
    dem_vec_cross(of->spin, d, own);
    dem_wall_drive_along(of->velocity, n, dem_vec_norm(of->velocity), own);
    dem_vec_cross(of->axis, d, around);
    dem_wall_drive_along(around, n, of->speed, own);
}

/* Add this motion and its spin at a contact. Its component along the normal of the contact is ignored:
   a surface that slides in itself does not push. pose: of the wall's frame; NULL: at rest. */
DEM_MATH void dem_wall_drive_add(const struct dem_wall_drive *of, const struct dem_pose *pose,
                                 const struct dem_facet *r, const double point[3],
                                 const double normal[3], double velocity[3], double wall_spin[3])
{
    double run[3], spin[3] = {of->spin[0], of->spin[1], of->spin[2]};

    if (!pose)
    {
        dem_wall_drive_velocity(of, r, point, normal, run);
    }
    else
    {
        double x[3], n[3], own[3];

        dem_pose_to_frame(pose, point, x);
        dem_pose_direction_to_frame(pose, normal, n);
        dem_wall_drive_velocity(of, r, x, n, own);
        dem_pose_direction(pose, own, run);
        dem_pose_direction(pose, of->spin, spin);
    }
    const double along = dem_vec_dot(run, normal);

    for (int k = 0; k < 3; k++)
    {
        velocity[k] += run[k] - along*normal[k];
        wall_spin[k] += spin[k];
    }
}
