/*
 * wall_kind.h -- what a contact with a wall feels besides its place: how the surface moves there and how it is curved.
 *
 * Reduced radius at a sphere of radius A, from outside and inside:    1/R* = 1/R + 1/A,   1/R* = 1/R - 1/A
 * at a cylinder, curved one way only:                                 R* = sqrt(R R1),    1/R1 = 1/R +- 1/A
 *
 * The first is Hertz's own. At a cylinder the area of contact is an ellipse; with the geometric mean of both radii the force
 * is within 1 % of Hertz's up to R/A = 0.5 from inside and 1 from outside, within 3 % up to 0.7 and 2.5.
 *
 * Source: Johnson, Contact Mechanics (1985), section 4.2: R_e = sqrt(R' R'') and the correction F_2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_WALL_KIND_H
#define DEM_STEP_WALL_KIND_H

#include "state/particles.h"
#include "step/wall_touch.h"

struct dem_wall_kind
{
    double velocity[3], spin[3];                          /* m/s of the wall's surface at the contact, 1/s of the wall */
    double half[3];                                       /* unit normal half a step ago */
    double reduced_radius;                                /* m */
};

/* Velocity and spin alone, over the last motion of the walls; `ahead`: the touch lies where the wall was before it. */
void dem_wall_kind_motion(const struct dem_walls *, int region, const struct dem_wall_touch *, int ahead, struct dem_wall_kind *);

struct dem_parts;

/* The near's surface follows a mesh and is on its way in this advance. */
int dem_wall_kind_drifts(const struct dem_parts *, uint32_t near);

/* Velocity and spin of such a surface at the contact; and the same added to what else the wall does. */
void dem_wall_kind_drift(const struct dem_parts *, uint32_t near, double velocity[3], double spin[3]);
void dem_wall_kind_add_drift(const struct dem_parts *, uint32_t near, double dt, struct dem_wall_kind *);

void dem_wall_kind_at(const struct dem_walls *, int region, const struct dem_particle *, const struct dem_wall_touch *, double dt,
                      struct dem_wall_kind *);

#endif
