/*
 * wall_surface.c -- velocity, normal half a step ago and reduced radius of a wall at a contact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/wall_surface.h"
#include "core/vec.h"
#include "walls/facet_surface.h"
#include <string.h>

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
        dem_wall_drive_add(&of->drive, of->frame < 0 ? NULL : &w->frame[of->frame].pose,
                           &w->facet[facet], at->point, at->normal, surface->velocity,
                           surface->spin);
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
