/*
 * wall_kind.c -- velocity, normal half a step ago and curvature of a wall at a contact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/wall_kind.h"
#include "base/vec.h"
#include "step/parts.h"
#include <math.h>
#include <string.h>

/* A wall inside which a particle can't fit is taken to be this much wider than it. */
static const double least_room = 1e-3;

static double reduced_radius(const struct dem_region *r, double radius)
{
    const double ratio = radius/r->radius, bend = r->outside ? 1.0 + ratio : fmax(1.0 - ratio, least_room);

    switch (r->shape)
    {
    case DEM_SHAPE_SPHERE: return radius/bend;
    case DEM_SHAPE_CYLINDER: return radius/sqrt(bend);
    default: return radius;
    }
}

/* A surface that runs in itself; what the given velocity has along the normal does not count. */
static void add_drive(const struct dem_walls *w, const struct dem_wall *of, const struct dem_wall_touch *at, struct dem_wall_kind *kind)
{
    double room[3], d[3], own[3], run[3], spin[3];
    const double *const x = of->moving < 0 ? at->point : (dem_pose_own(&w->moving[of->moving].pose, at->point, room), room);

    dem_vec_minus(x, of->drive_origin, d);
    dem_vec_cross(of->drive_spin, d, own);
    for (int k = 0; k < 3; k++)
    {
        own[k] += of->drive[k];
    }
    memcpy(run, own, sizeof run);
    memcpy(spin, of->drive_spin, sizeof spin);
    if (of->moving >= 0)
    {
        dem_pose_direction(&w->moving[of->moving].pose, own, run);
        dem_pose_direction(&w->moving[of->moving].pose, of->drive_spin, spin);
    }
    const double along = dem_vec_dot(run, at->normal);

    for (int k = 0; k < 3; k++)
    {
        kind->velocity[k] += run[k] - along*at->normal[k];
        kind->spin[k] += spin[k];
    }
}

/* The normal a step ago: of the face as it stood then, or of a round wall where the particle was then. */
static void normal_before(const struct dem_region *r, const struct dem_stride *s, const double back[3], const struct dem_wall_touch *at,
                          double before[3])
{
    double d[3];

    if (r->shape == DEM_SHAPE_PLANE || r->shape == DEM_SHAPE_TRIANGLES)
    {
        dem_stride_back(s, at->normal, before);
        return;
    }
    /* towards the axis or centre: a height of 1 along n is so much of the particle's distance from it */
    const double reach = r->outside ? r->radius + at->distance : r->radius - at->distance;
    double along = 0.0;

    for (int k = 0; k < 3; k++)
    {
        d[k] = (r->outside ? reach : -reach)*at->normal[k] - back[k];
    }
    for (int k = 0; k < 3 && r->shape == DEM_SHAPE_CYLINDER; k++)
    {
        along += d[k]*r->normal[k];
    }
    const double size = sqrt(fmax(dem_vec_dot(d, d) - along*along, 0.0));

    for (int k = 0; k < 3; k++)
    {
        const double flat = d[k] - (r->shape == DEM_SHAPE_CYLINDER ? along*r->normal[k] : 0.0);

        before[k] = size > 0.0 ? (r->outside ? flat : -flat)/size : at->normal[k];
    }
}

static const struct dem_stride rest;

/* Forward from x the chord bends the other way. */
void dem_wall_kind_motion(const struct dem_walls *w, int region, const struct dem_wall_touch *at, int ahead, struct dem_wall_kind *kind)
{
    const struct dem_wall *const of = &w->wall[w->region[region].wall];
    struct dem_stride s = of->moving < 0 ? rest : w->moving[of->moving].stride;

    s.versine_rate = ahead ? -s.versine_rate : s.versine_rate;
    dem_stride_velocity(&s, at->point, kind->velocity);
    for (int k = 0; k < 3; k++)
    {
        kind->spin[k] = s.sine_rate*s.axis[k];
    }
    if (of->driven)
    {
        add_drive(w, of, at, kind);
    }
}

void dem_wall_kind_at(const struct dem_walls *w, int region, const struct dem_particle *i, const struct dem_wall_touch *at, double dt,
                      struct dem_wall_kind *kind)
{
    const struct dem_region *const r = &w->region[region];
    const struct dem_wall *const of = &w->wall[r->wall];
    const struct dem_stride *const s = of->moving < 0 ? &rest : &w->moving[of->moving].stride;
    double back[3], before[3], centre[3] = {0.0, 0.0, 0.0};

    dem_wall_kind_motion(w, region, at, 0, kind);
    if (r->shape == DEM_SHAPE_CYLINDER || r->shape == DEM_SHAPE_SPHERE)
    {
        memcpy(centre, r->centre, sizeof centre);
        if (of->moving >= 0)
        {
            dem_pose_point(&w->moving[of->moving].pose, r->centre, centre);
        }
        dem_stride_velocity(s, centre, centre);
    }
    for (int k = 0; k < 3; k++)
    {
        back[k] = dt*(i->v[k] - centre[k]);
    }
    normal_before(r, s, back, at, before);
    for (int k = 0; k < 3; k++)
    {
        kind->half[k] = at->normal[k] + before[k];
    }
    const double size = dem_vec_norm(kind->half);

    for (int k = 0; k < 3; k++)
    {
        kind->half[k] = size > 0.0 ? kind->half[k]/size : at->normal[k];
    }
    kind->reduced_radius = reduced_radius(r, i->radius);
}

/* ---- walls that follow a mesh -------------------------------------------------------------------------------- */

int dem_wall_kind_drifts(const struct dem_parts *p, uint32_t near)
{
    return p->walls.following > 0 && p->walls.wall[p->walls.region[p->pairs.wall_region[near]].wall].goes;
}

void dem_wall_kind_drift(const struct dem_parts *p, uint32_t near, double velocity[3], double spin[3])
{
    const struct dem_wall_search *const s = &p->pairs.search;
    const double *const x = p->particles.record[s->near[near].particle].x;

    dem_walls_drift(&p->walls, dem_wall_near_triangle(s, &p->walls, &s->near[near], x), p->touches.touch[near].point, velocity, spin);
}

void dem_wall_kind_add_drift(const struct dem_parts *p, uint32_t near, double dt, struct dem_wall_kind *kind)
{
    const double *const n = p->touches.touch[near].normal;
    double velocity[3], spin[3], back[3];

    dem_wall_kind_drift(p, near, velocity, spin);
    dem_vec_cross(spin, n, back);
    for (int k = 0; k < 3; k++)
    {
        kind->velocity[k] += velocity[k];
        kind->spin[k] += spin[k];
        kind->half[k] = n[k] - 0.5*dt*back[k];
    }
    const double size = dem_vec_norm(kind->half);

    for (int k = 0; k < 3; k++)
    {
        kind->half[k] /= size;
    }
}
