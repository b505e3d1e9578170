/*
 * wall_motion.h -- how walls move: a function of time, so that a wall is where it belongs at any time and after any restart.
 *
 * A wall's corners and planes are given, searched and numbered in the wall's own frame X, where it stands when nothing
 * moves. The motion says where that frame is:
 *
 *   x = Q X + s,   translation   s = v T
 *                  oscillation   s = a sin(2 pi f T + phase)
 *                  rotation      Q: by the angle omega T about the axis through the origin o,  s = o - Q o
 *
 *   T   time since the start, not before it and not past the end: outside these the wall rests          [s]
 *
 * The velocity of a point of the wall is that of the chord of the last step, (x(t) - x(t - dt))/dt, which is what drifts
 * of particles are, too: what moves with the wall has no slip at all.
 *
 * Not here: which wall moves how (walls), when lists are stale (walls, step).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STATE_WALL_MOTION_H
#define DEM_STATE_WALL_MOTION_H

enum dem_motion_kind
{
    DEM_MOTION_REST,
    DEM_MOTION_TRANSLATION,
    DEM_MOTION_ROTATION,
    DEM_MOTION_OSCILLATION
};

struct dem_motion
{
    enum dem_motion_kind kind;
    double start, end;                                    /* s */
    double velocity[3];                                   /* m/s  translation */
    double amplitude[3], frequency, phase;                /* m, 1/s, rad: oscillation */
    double origin[3], axis[3], omega;                     /* m, unit, rad/s: rotation */
};

struct dem_pose                                           /* Q and s */
{
    double turn[3][3], shift[3];
};

struct dem_stride                                         /* a motion over the last step */
{
    double velocity[3];                                   /* m/s of all points alike */
    double origin[3], axis[3];                            /* m, unit */
    double sine, versine;                                 /* of the angle turned: sin, 1 - cos */
    double sine_rate, versine_rate;                       /* the same over dt; omega and 0 where dt is 0 [1/s] */
};

void dem_motion_pose(const struct dem_motion *, double time, struct dem_pose *);

/* The step of length dt that ends at `time`; dt 0 gives the velocity at that time. */
void dem_motion_stride(const struct dem_motion *, double time, double dt, struct dem_stride *);

/* Velocity [m/s] of the wall's point that is at x now. */
void dem_stride_velocity(const struct dem_stride *, const double x[3], double v[3]);

/* What the direction n of the wall was a step ago. */
void dem_stride_back(const struct dem_stride *, const double n[3], double before[3]);

/* From the wall's frame to the world, a point and a direction, and back, a point. `in` and `out` differ. */
void dem_pose_point(const struct dem_pose *, const double in[3], double out[3]);
void dem_pose_direction(const struct dem_pose *, const double in[3], double out[3]);
void dem_pose_own(const struct dem_pose *, const double in[3], double out[3]);

#endif
