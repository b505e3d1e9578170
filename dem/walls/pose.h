/*
 * pose.h -- pose of the reference frame of a wall that moves, and its displacement over a step: what
 * contacts read of a motion (wall_motion.h). Devices compile it, too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/vec.h"

struct dem_pose                                           /* of a reference frame: Q and s */
{
    double rotation[3][3], shift[3];  /* 1, m */
};

/* displacement by a motion over the last step */
struct dem_wall_displacement
{
    double velocity[3];              /* m/s: of translation */
    double origin[3], axis[3];       /* m, unit: of rotation */
    double sine, versine;            /* of the angle of rotation: sin, 1 - cos */
    double sine_rate, versine_rate;  /* 1/s: the same over dt; omega and 0 when dt is 0 */
};

/* Velocity [m/s] of the material point of the wall that is at x [m] now:
   x - x(t - dt) = sin k x d - (1 - cos) k x (k x d), d = x - origin */
DEM_MATH void dem_wall_displacement_velocity(const struct dem_wall_displacement *s,
                                             const double x[3], double v[3])
{
    double d[3], once[3], twice[3];

    dem_vec_minus(x, s->origin, d);
    dem_vec_cross(s->axis, d, once);
    dem_vec_cross(s->axis, once, twice);
    for (int k = 0; k < 3; k++)
    {
        v[k] = s->velocity[k] + s->sine_rate*once[k] - s->versine_rate*twice[k];
    }
}

/* The direction one step ago of what is now the direction n of the wall. */
DEM_MATH void dem_wall_displacement_rotate_back(const struct dem_wall_displacement *s,
                                                const double n[3], double before[3])
{
    double once[3], twice[3];

    dem_vec_cross(s->axis, n, once);
    dem_vec_cross(s->axis, once, twice);
    for (int k = 0; k < 3; k++)
    {
        before[k] = n[k] - s->sine*once[k] + s->versine*twice[k];
    }
}

/* From the wall's frame to the global frame: a direction, a point. Back: the same. `in` and `out` must
   be different arrays. */
DEM_MATH void dem_pose_direction(const struct dem_pose *p, const double in[3], double out[3])
{
    for (int k = 0; k < 3; k++)
    {
        out[k] = dem_vec_dot(p->rotation[k], in);
    }
}

DEM_MATH void dem_pose_point(const struct dem_pose *p, const double in[3], double out[3])
{
    for (int k = 0; k < 3; k++)
    {
        out[k] = dem_vec_dot(p->rotation[k], in) + p->shift[k];
    }
}

DEM_MATH void dem_pose_direction_to_frame(const struct dem_pose *p, const double in[3], double out[3])
{
    for (int k = 0; k < 3; k++)
    {
        out[k] = p->rotation[0][k]*in[0] + p->rotation[1][k]*in[1] + p->rotation[2][k]*in[2];
    }
}

DEM_MATH void dem_pose_to_frame(const struct dem_pose *p, const double in[3], double out[3])
{
    double d[3];

    dem_vec_minus(in, p->shift, d);
    dem_pose_direction_to_frame(p, d, out);
}
