/*
 * wall_motion.h -- prescribed rigid motion of walls as a function of time.
 *
 * The motion is a closed formula of time. The corners and planes of a wall are stored, searched and
 * numbered in its own reference frame X, where the wall is when nothing moves. The motion gives the
 * pose of this frame:
 *
 *   x = Q (B X) + s,   translation   s = v T
 *                  oscillation   s = a sin(2 pi f T + phase)
 *                  rotation      Q: by the angle omega T about the axis through the origin o,
 *                                s = o - Q o
 *
 *   B   base: the identity, unless a restart has changed the motion of the wall; then the pose that
 *       lets the wall go on from where it stood (wall_frames.c)
 *   T   time since the start, limited to [0, end - start]; outside the wall rests             [s]
 *
 * A point of the wall has the velocity of the chord of the last step, (x(t) - x(t - dt))/dt, as
 * particles have: what moves with the wall has exactly no slip.
 *
 * Several motions of one wall, tables, and walls moved by force: compound_motion.h.
 * Which wall has which motion, and the bound of its displacement for the lists: walls.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "walls/pose.h"
#include <stdint.h>

enum dem_motion_kind
{
    DEM_MOTION_REST,
    DEM_MOTION_TRANSLATION,
    DEM_MOTION_ROTATION,
    DEM_MOTION_OSCILLATION,
    DEM_MOTION_TABLE,                       /* part of a compound only */
    DEM_MOTION_COMPOUND                     /* of a frame: see compound_motion.h */
};

/* Rates [1/s, rad/s], phases [rad] and start [s] of a motion lie below it, so angles are finite. */
#define DEM_MOTION_LIMIT 1e15

struct dem_motion
{
    enum dem_motion_kind kind;
    int16_t stage[2];                       /* of the scene whose beginning start and end are, from 1;
                                               0: none */
    double start, end;                      /* s; infinite before that stage begins */
    double longest;                         /* s  from start to end at most, where a stage decides */
    double velocity[3];                     /* m/s  translation */
    double amplitude[3], frequency, phase;  /* m, 1/s, rad: oscillation */
    double origin[3], axis[3], omega;       /* m, unit, rad/s: rotation */
};

/* of a frame that is where its wall was given */
static const struct dem_pose dem_pose_identity = {
    .rotation = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

/* From start to end [s]; at most, where a stage decides. */
double dem_motion_duration(const struct dem_motion *);
/* Rotation by an angle [rad] about a unit axis through the origin. */
void dem_pose_rotate(const double origin[3], const double axis[3], double angle, struct dem_pose *);

/* Time since the start [s], limited to [0, end - start]. */
double dem_motion_time(const struct dem_motion *, double time);

/* Pose of the reference frame at a time [s]. */
void dem_motion_pose(const struct dem_motion *, double time, struct dem_pose *);

/* Velocity [m/s] with which the motion carries the point x [m] of the base: the largest one
   of an oscillation. */
void dem_motion_velocity(const struct dem_motion *, const double x[3], double v[3]);

/* Longest time step [s] that resolves an oscillation or rotation that acts after time 0; DBL_MAX
   without one. *why: the criterion, to be followed by the name of the wall. */
double dem_motion_time_limit(const struct dem_motion *, const char **why);

/* Displacement over the step of length dt [s] that ends at `time` [s]; dt = 0 gives the velocity
   then. */
void dem_motion_displacement(const struct dem_motion *, double time, double dt,
                             struct dem_wall_displacement *);

/* The pose that applies b first, then a; the inverse of a pose. The results must be other structs. */
void dem_pose_product(const struct dem_pose *a, const struct dem_pose *b, struct dem_pose *product);
void dem_pose_inverse(const struct dem_pose *, struct dem_pose *inverse);
