/*
 * wall_surface.c -- velocity, normal half a step ago and reduced radius of a wall at a contact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/wall_surface.h"
#include "core/vec.h"
#include "walls/facet_surface.h"
#include <math.h>
#include <string.h>

/* Sine of the angle between a face and the direction of a belt, below which the face has no
   direction along it. Above the error of the normals of an STL file in single precision. */
static const double min_sine = 1e-3;

/* Add a belt's velocity along a face: `direction` projected on the face, with this speed [m/s]. */
static void add_along_face(const double direction[3], const double normal[3], double speed,
                           double sum[3])
{
    const double across = dem_vec_dot(direction, normal);
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
   direction `drive`, a belt around an axis, a solid that turns:

     |drive| unit(P drive) + speed unit(P (axis x d)) + spin x d
     d = x - origin,  P v = v - (v.n) n

   n is the normal of the face also where the contact is on its edge, so a ball leaves the end of a
   belt with the velocity of the belt. */
static void velocity_in_surface(const struct dem_wall *of, const struct dem_facet *r,
                                const double x[3], const double contact_normal[3], double own[3])
{
    const double *const n =
        r->shape == DEM_SHAPE_TRIANGLES && !r->bent ? r->normal : contact_normal;
    double d[3], around[3];

    dem_vec_minus(x, of->drive_origin, d);
    dem_vec_cross(of->drive_spin, d, own);
    add_along_face(of->drive, n, dem_vec_norm(of->drive), own);
    dem_vec_cross(of->drive_axis, d, around);
    add_along_face(around, n, of->drive_speed, own);
}

/* Add the motion of a surface in itself, like a conveyor belt. Its component along the normal of
   the contact is ignored: a surface that slides in itself does not push. */
static void add_surface_velocity(const struct dem_walls *w, const struct dem_facet *r,
                                 const struct dem_wall_touch *at, struct dem_wall_surface *surface)
{
    const struct dem_wall *const of = &w->wall[r->wall];
    double run[3], spin[3];

    if (of->frame < 0)
    {
        velocity_in_surface(of, r, at->point, at->normal, run);
        memcpy(spin, of->drive_spin, sizeof spin);
    }
    else
    {
        const struct dem_pose *const pose = &w->frame[of->frame].pose;
        double x[3], n[3], own[3];

        dem_pose_to_frame(pose, at->point, x);
        dem_pose_direction_to_frame(pose, at->normal, n);
        velocity_in_surface(of, r, x, n, own);
        dem_pose_direction(pose, own, run);
        dem_pose_direction(pose, of->drive_spin, spin);
    }
    const double along = dem_vec_dot(run, at->normal);

    for (int k = 0; k < 3; k++)
    {
        surface->velocity[k] += run[k] - along*at->normal[k];
        surface->spin[k] += spin[k];
    }
}

static const struct dem_wall_displacement rest;

/* From the position before the motion, the chord of the rotation deviates from the tangent to the
   other side. */
void dem_wall_surface_motion(const struct dem_walls *w, int facet, const struct dem_wall_touch *at,
                             int ahead, struct dem_wall_surface *surface)
{
    const struct dem_wall *const of = &w->wall[w->facet[facet].wall];
    struct dem_wall_displacement s = of->frame < 0 ? rest : w->frame[of->frame].displacement;

    s.versine_rate = ahead ? -s.versine_rate : s.versine_rate;
    dem_wall_displacement_velocity(&s, at->point, surface->velocity);
    for (int k = 0; k < 3; k++)
    {
        surface->spin[k] = s.sine_rate*s.axis[k];
    }
    if (of->driven)
    {
        add_surface_velocity(w, &w->facet[facet], at, surface);
    }
}

void dem_wall_surface_at(const struct dem_walls *w, int facet, const struct dem_particle *i,
                         const struct dem_wall_touch *at, double dt,
                         struct dem_wall_surface *surface)
{
    const struct dem_facet *const r = &w->facet[facet];
    const struct dem_wall *const of = &w->wall[r->wall];
    const struct dem_wall_displacement *const s =
        of->frame < 0 ? &rest : &w->frame[of->frame].displacement;
    const struct dem_pose *const pose = of->frame < 0 ? NULL : &w->frame[of->frame].pose;

    dem_wall_surface_motion(w, facet, at, 0, surface);
    dem_facet_normal_half_step(
        r,
        &(struct dem_facet_step){.displacement = s,
                                 .pose = pose,
                                 .v = {i->v[0], i->v[1], i->v[2]},
                                 .dt = dt},
        at->normal, at->distance, surface->half_step_normal);
    surface->reduced_radius = dem_facet_reduced_radius(r, i->radius);
}

/* ---- walls that follow a mesh ---------------------------------------------------------------- */

int dem_wall_surface_follows_mesh(const struct dem_walls *w, int facet)
{
    return w->following > 0 && w->wall[w->facet[facet].wall].moves;
}

void dem_wall_surface_add_mesh_motion(const struct dem_walls *w, const struct dem_wall_search *s,
                                      uint32_t wall_neighbor, const double x[3],
                                      const struct dem_wall_touch *at, double dt,
                                      struct dem_wall_surface *surface)
{
    const uint32_t candidate =
        dem_wall_neighbor_candidate(s, w, &s->neighbor[wall_neighbor], x);
    double moved[3], velocity[3], spin[3], back[3];

    dem_walls_surface_motion(w, s->candidate[candidate],
                             dem_wall_from_candidate(s, w, candidate, at->point, moved),
                             velocity, spin);
    dem_vec_cross(spin, at->normal, back);
    for (int k = 0; k < 3; k++)
    {
        surface->velocity[k] += velocity[k];
        surface->spin[k] += spin[k];
        surface->half_step_normal[k] = at->normal[k] - 0.5*dt*back[k];
    }
    const double size = dem_vec_norm(surface->half_step_normal);

    for (int k = 0; k < 3; k++)
    {
        surface->half_step_normal[k] /= size;
    }
}
