/*
 * compound_motion.h -- motions of a wall one after the other, from tables, and by force.
 *
 *   x = M_n ... M_2 (M_1 (B X))
 *
 * The first motion acts in the body, the last one in space: a rotation about the wall's own axis, then a
 * rotation about the axis of a mill, is planetary motion. A motion is a closed formula
 * (wall_motion.h) or a table of displacements and an angle over time:
 *
 *   x = o + Q (X - o) + s,    s, Q: row of the table at the time since the start; Q about an axis
 *                             through o
 *
 * A wall that is moved by force (wall_body.h) has this as its last motion. The velocity of the wall is
 * the chord of the last step, from the poses P at both ends:
 *
 *   P(t) P(t - dt)^-1:  the rotation R = Q(t) Q(t - dt)^T, with its axis from R - R^T
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "input/time_table.h"
#include "walls/wall_body.h"
#include "walls/wall_motion.h"

enum
{
    DEM_MOTION_PARTS = 4
};

struct dem_motion_part
{
    struct dem_motion motion;             /* of a table: kind, start, end, origin, axis */
    struct dem_time_table *table;         /* m, m, m, rad; NULL: a formula */
};

struct dem_compound_motion
{
    int parts;
    struct dem_motion_part part[DEM_MOTION_PARTS];
    struct dem_wall_body *body;           /* moved by force, after the parts; NULL: not */
};

void dem_compound_motion_free(struct dem_compound_motion *);    /* NULL is allowed */

/* Pose at a time [s], with the body's present displacement; displacement over the step of length dt
   that ends then. */
void dem_compound_motion_pose(const struct dem_compound_motion *, double time, struct dem_pose *);
void dem_compound_motion_displacement(const struct dem_compound_motion *, double time, double dt,
                                      struct dem_wall_displacement *);

/* The largest velocity [m/s] that its parts give to the point x [m] of the base, added up without
   their signs. */
void dem_compound_motion_velocity(const struct dem_compound_motion *, const double x[3], double v[3]);

/* As dem_motion_time_limit; a table is resolved by 4 steps between two rows. */
double dem_compound_motion_time_limit(const struct dem_compound_motion *, const char **why);

/* The first two rows of a table that are nearer than those 4 steps of `step` [s]: their times [s];
   returns 0 when there are none. */
int dem_compound_motion_dense_rows(const struct dem_compound_motion *, double step, double time[2]);

/* Bound of the speed [m/s] of the points of a box. */
double dem_compound_motion_speed(const struct dem_compound_motion *, const double (*box)[3]);

/* The axis of a part that rotates and leans off a coordinate axis, or NULL: all rotations are about
   it. *rotates: 1 when a part rotates. */
const double *dem_compound_motion_leans(const struct dem_compound_motion *, int axis, int *rotates);

/* Its only motion when that is a table that only turns, with origin and axis; else NULL. */
const struct dem_motion *dem_compound_motion_turns(const struct dem_compound_motion *);

/* differ between motions that lead to other poses; forces and masses of a body do not count */
struct dem_motion_hash
{
    uint64_t formulas, tables, body;      /* of the parts: entries, rows of tables; 0: no body */
};

struct dem_motion_hash dem_compound_motion_hash(const struct dem_compound_motion *);
