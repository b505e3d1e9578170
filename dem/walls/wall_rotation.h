/*
 * wall_rotation.h -- rotation of a free wall about its centre of mass, about one axis that is fixed in space or
 * about all.
 *
 *   kick    L += h (T + t - c w+)
 *   drift   R by rotations about the principal axes with L kept (particles/clump.h)
 *
 *   L       angular momentum about the centre, in space                         [kg m2/s]
 *   h       length of a kick                                                    [s]
 *   T, t    given torque; torque of the particles in the last sweep             [N m]
 *   w       spin R I^-1 R^T L; w+ after the kick                                [1/s]
 *   c       damping coefficient                                                 [N m s/rad]
 *   R, I    rotation; principal moments of inertia                              [1], [kg m2]
 *
 * With one axis a only the components of T, t and L along it count, and I = a.(inertia tensor)a.
 *
 * Limits: K dt^2 < 0.04 I in each sweep, with K = sum k d^2 over the contacts, d their distances from the
 * centre or the axis; |w| dt <= 0.3.
 *
 * Sums over the contacts and limits: step/wall_bodies.c; mass, centre and inertia from the density:
 * case/setup_bodies.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "walls/wall_body.h"

/* Centre and principal axes of a wall that begins at the pose `base` of its frame. */
void dem_wall_rotation_prepare(struct dem_wall_rotation *, const struct dem_pose *base);

/* The angular momentum of its spin at the start. */
void dem_wall_rotation_start(struct dem_wall_body *);

/* 1 when no rigid body has these moments of inertia, to the rounding of printed numbers. */
int dem_wall_rotation_impossible(const struct dem_wall_rotation *);

/* The rotation about the centre, without displacements; `before`: a step ago. */
void dem_wall_rotation_pose(const struct dem_wall_body *, int before, struct dem_pose *);

/* Parts of dem_wall_body_kick, dem_wall_body_drift and dem_wall_body_kinetic. */
void dem_wall_rotation_kick(struct dem_wall_body *, const struct dem_wall_body_kick *,
                        struct dem_wall_body_work *);
void dem_wall_rotation_drift(struct dem_wall_body *, double dt);
double dem_wall_rotation_kinetic(const struct dem_wall_body *);    /* J */

void dem_wall_rotation_spin(const struct dem_wall_body *, double w[3]);    /* 1/s */

/* The least moment of inertia about which it may rotate [kg m2]. */
double dem_wall_rotation_least_inertia(const struct dem_wall_rotation *);
