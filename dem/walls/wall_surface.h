/*
 * wall_surface.h -- properties of a wall's surface at a contact: its velocity, its normal half a
 * step ago, and the reduced radius.
 *
 * At a sphere of radius A, from outside and inside:     1/R* = 1/R + 1/A,   1/R* = 1/R - 1/A
 * at a cylinder, which is curved in one direction only:  R* = sqrt(R R1),    1/R1 = 1/R +- 1/A
 *
 * The first is Hertz's own. At a cylinder the contact area is an ellipse; with the geometric mean
 * of both radii the force is within 1 % of Hertz's up to R/A = 0.5 from inside and 1 from outside,
 * within 3 % up to 0.7 and 2.5.
 *
 * Source: Johnson, Contact Mechanics (1985), section 4.2: R_e = sqrt(R' R'') and the correction
 * F_2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/particles.h"
#include "walls/wall_touch.h"

struct dem_wall_surface
{
    double velocity[3], spin[3];  /* m/s of the wall's surface at the contact, 1/s of the wall */
    double half_step_normal[3];   /* unit normal half a step ago */
    double reduced_radius;        /* m */
};

/* Velocity and spin only, over the last motion of the walls. `ahead`: 1 when the contact point is
   that before this motion. */
void dem_wall_surface_motion(const struct dem_walls *, int facet, const struct dem_wall_touch *,
                             int ahead, struct dem_wall_surface *);

/* 1 when the facet follows a mesh and moves in this window. */
int dem_wall_surface_follows_mesh(const struct dem_walls *, int facet);

/* Add the velocity and spin of such a surface to the other motion of the wall, at the contact with a
   particle at x [m]. */
void dem_wall_surface_add_mesh_motion(const struct dem_walls *, const struct dem_wall_search *,
                                      uint32_t wall_neighbor, const double x[3],
                                      const struct dem_wall_touch *, double dt,
                                      struct dem_wall_surface *);

/* All properties of the wall at the contact of particle i, but for the motion of a mesh. */
void dem_wall_surface_at(const struct dem_walls *, int facet, const struct dem_particle *i,
                         const struct dem_wall_touch *, double dt, struct dem_wall_surface *);
