/*
 * gather.cl -- what the kernels share: when a step is not made, the maximum of a group, the geometry
 * of a pair and of a contact with a wall, and what ends a run.
 *
 * A record of a particle is four double4: {x, radius} {v, 1/m} {w, 1/I} {m, id, bits, -}
 * (struct dem_particle).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "contacts/geometry.h"
#include "core/random.h"
#include "device/shared.h"
#include "walls/facet_surface.h"
#include "walls/wall_drive.h"

/* 1 when the lists may miss a contact in step s of the batch: the step is left out. All work items of
   all kernels of a step get the same answer. The bound grows with the largest speed of each step; the
   factor is above all rounding. Steps after an event are made, too; the host drops the batch. */
static int dem_used_up(constant struct dem_device_batch *b, global struct dem_device_report *report,
                       uint s)
{
    const float bound = s == 0 ? b->start
                               : report->bound[s - 1] + sqrt(report->fastest[s - 1])*
                                                            (float)(b->dt*1.0001);

    if (get_global_id(0) == 0)
    {
        report->bound[s] = bound;
    }
    return !(bound <= b->limit[s]);
}

/* The largest number of a group, one of each work item, joins *largest. The whole group calls it. */
static void dem_group_max(local uint *part, global uint *largest)
{
    const uint l = get_local_id(0);

    barrier(CLK_LOCAL_MEM_FENCE);
    for (uint d = DEM_DEVICE_GROUP/2; d > 0; d /= 2)
    {
        if (l < d)
        {
            part[l] = max(part[l], part[l + d]);
        }
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    if (l == 0)
    {
        atomic_max((volatile global uint *)largest, part[0]);
    }
}

static void dem_report_event(global struct dem_device_report *report, uint event, uint s)
{
    atomic_or((volatile global uint *)&report->events, event);
    atomic_min((volatile global uint *)&report->event_step, s);
}

/* ---- geometry ---------------------------------------------------------------------------------- */

static void dem_row_begin(constant struct dem_device_batch *b, uint s, struct dem_contact_row *r)
{
    const int64_t step = b->first + (int64_t)s;

    r->dt = b->dt;
    r->max_dt = b->max_dt;
    r->inverse_dt = b->inverse_dt;
    r->time = b->window_start + (double)step*b->dt;
    r->previous_time = b->window_start + (double)(step - 1)*b->dt;
    r->viscosity = r->pair_random = r->bond_replaces = r->scratch = r->adhesive_force = 0.0;
    r->kn = r->kt = r->eta = r->fn = r->fx = r->fy = r->fz = r->mx = r->my = r->mz = 0.0;
    r->stored = r->lost = r->bonds = r->broke = r->cause = r->dissipated = 0.0;
    r->is_primary = 1.0;
}

static void dem_row_of_pair(global const double4 *restrict record, uint2 partners,
                            global const double4 *restrict shift, int random, int scalars,
                            struct dem_gathered *gathered, struct dem_contact_row *r)
{
    const uint i = partners.x, j = partners.y & ((1u << 27) - 1);
    const double4 xi = record[4*(size_t)i], xj = record[4*(size_t)j],
                  vi = record[4*(size_t)i + 1], vj = record[4*(size_t)j + 1],
                  wi = record[4*(size_t)i + 2], wj = record[4*(size_t)j + 2],
                  t = shift[partners.y >> 27];
    struct dem_gathered g;

    g.rx[0] = xi.x - xj.x + t.x;
    g.ry[0] = xi.y - xj.y + t.y;
    g.rz[0] = xi.z - xj.z + t.z;
    g.radii[0] = xi.w + xj.w;
    g.vx[0] = vi.x - vj.x;
    g.vy[0] = vi.y - vj.y;
    g.vz[0] = vi.z - vj.z;
    /* frozen partners exchange scalars */
    g.inverse_mass[0] = scalars && !(vi.w + vj.w > 0.0) ? 1.0 : vi.w + vj.w;
    g.ax[0] = xi.w*wi.x + xj.w*wj.x;
    g.ay[0] = xi.w*wi.y + xj.w*wj.y;
    g.az[0] = xi.w*wi.z + xj.w*wj.z;
    g.bx[0] = wi.x + wj.x;
    g.by[0] = wi.y + wj.y;
    g.bz[0] = wi.z + wj.z;
    g.radius[0] = xi.w;
    g.other[0] = xj.w;
    r->wx = wi.x - wj.x;
    r->wy = wi.y - wj.y;
    r->wz = wi.z - wj.z;
    dem_geometry_pair(&g, 0, r->dt, r);
    dem_geometry_motion(&g, 0, 1.0, r);
    r->distance = sqrt(g.rx[0]*g.rx[0] + g.ry[0]*g.ry[0] + g.rz[0]*g.rz[0]);
    r->gap = r->distance - g.radii[0];
    if (random)
    {
        r->pair_random = dem_random_unit(as_ulong(record[4*(size_t)i + 3].y),
                                         as_ulong(record[4*(size_t)j + 3].y), 0, 0);
    }
    *gathered = g;
}

/* Contact of a particle at x with a facet: distance [m], and point and normal. */
static double dem_wall_touch(global const struct dem_facet *restrict in_memory,
                             global const struct dem_device_frame *restrict frames,
                             const double x[3], double point[3], double normal[3])
{
    const struct dem_facet facet = *in_memory;
    double own[3], own_point[3], own_normal[3];

    if (facet.wall < 0)
    {
        return dem_facet_touch(&facet, x, x, point, normal);
    }
    const struct dem_pose pose = frames[facet.wall].pose;

    dem_pose_to_frame(&pose, x, own);
    const double distance = dem_facet_touch(&facet, own, own, own_point, own_normal);

    dem_pose_direction(&pose, own_normal, normal);
    dem_pose_point(&pose, own_point, point);
    return distance;
}

/* Velocity of a wall's surface at a contact, and spin of the wall (dem_wall_surface_motion). ahead: the
   contact point is that before the motion. */
static void dem_wall_motion(global const struct dem_facet *restrict in_memory,
                            global const struct dem_device_frame *restrict frames,
                            global const struct dem_wall_drive *restrict drives, int ahead,
                            const double point[3], const double normal[3], double velocity[3],
                            double spin[3])
{
    const struct dem_facet facet = *in_memory;
    struct dem_pose pose;

    for (int k = 0; k < 3; k++)
    {
        velocity[k] = spin[k] = 0.0;
    }
    if (facet.wall >= 0)
    {
        struct dem_wall_displacement s = frames[facet.wall].displacement;

        pose = frames[facet.wall].pose;
        s.versine_rate = ahead ? -s.versine_rate : s.versine_rate;
        dem_wall_displacement_velocity(&s, point, velocity);
        spin[0] = s.sine_rate*s.axis[0];
        spin[1] = s.sine_rate*s.axis[1];
        spin[2] = s.sine_rate*s.axis[2];
    }
    if (facet.largest & DEM_DEVICE_DRIVEN)
    {
        const struct dem_wall_drive drive = drives[facet.largest >> 2];

        dem_wall_drive_add(&drive, facet.wall >= 0 ? &pose : 0, &facet, point, normal, velocity,
                           spin);
    }
}

/* What a wall that is curved, moves or conveys changes: relative velocities, the normal of half a
   step ago, the reduced radius. */
static void dem_row_add_surface(global const struct dem_facet *restrict in_memory,
                                global const struct dem_device_frame *restrict frames,
                                global const struct dem_wall_drive *restrict drives, double4 v,
                                const double point[3], double distance, struct dem_gathered *g,
                                struct dem_contact_row *r)
{
    const struct dem_facet facet = *in_memory;
    const double normal[3] = {r->nx, r->ny, r->nz};
    struct dem_wall_displacement s = {.sine = 0.0};
    struct dem_pose pose;
    double half_step[3], velocity[3], spin[3];

    if (facet.wall >= 0)
    {
        s = frames[facet.wall].displacement;
        pose = frames[facet.wall].pose;
    }
    dem_wall_motion(in_memory, frames, drives, 0, point, normal, velocity, spin);
    g->vx[0] -= velocity[0];
    g->vy[0] -= velocity[1];
    g->vz[0] -= velocity[2];
    r->wx -= spin[0];
    r->wy -= spin[1];
    r->wz -= spin[2];
    const struct dem_facet_step since = {.displacement = &s, .pose = facet.wall >= 0 ? &pose : 0,
                                         .v = {v.x, v.y, v.z}, .dt = r->dt};

    dem_facet_normal_half_step(&facet, &since, normal, distance, half_step);
    r->hx = half_step[0];
    r->hy = half_step[1];
    r->hz = half_step[2];
    r->reduced_radius = dem_facet_reduced_radius(&facet, r->min_radius);
}

/* contact: from facets.cl, or NULL. random: rows have a random number; surface: some wall of the scene is
   curved, moves or conveys. */
static void dem_row_of_wall(global const double4 *restrict record,
                            global const double4 *restrict contact,
                            global const struct dem_facet *restrict facet,
                            global const struct dem_device_frame *restrict frames,
                            global const struct dem_wall_drive *restrict drives, int random,
                            int surface, struct dem_gathered *gathered, struct dem_contact_row *r)
{
    const double4 x = record[0], v = record[1], w = record[2];
    const double at[3] = {x.x, x.y, x.z};
    double point[3], normal[3], h;
    struct dem_gathered g;

    if (contact)
    {
        const double4 p = contact[0], n = contact[1];

        vstore3(p.xyz, 0, point);
        vstore3(n.xyz, 0, normal);
        h = p.w;
    }
    else
    {
        h = dem_wall_touch(facet, frames, at, point, normal);
    }
    const double distance = h < 4.0*x.w ? h : 4.0*x.w;

    g.rx[0] = distance*normal[0];
    g.ry[0] = distance*normal[1];
    g.rz[0] = distance*normal[2];
    g.vx[0] = v.x;
    g.vy[0] = v.y;
    g.vz[0] = v.z;
    g.ax[0] = x.w*w.x;
    g.ay[0] = x.w*w.y;
    g.az[0] = x.w*w.z;
    g.bx[0] = 2.0*w.x;
    g.by[0] = 2.0*w.y;
    g.bz[0] = 2.0*w.z;
    r->nx = r->hx = normal[0];
    r->ny = r->hy = normal[1];
    r->nz = r->hz = normal[2];
    r->overlap = x.w - distance;
    r->min_radius = r->reduced_radius = x.w;
    r->reduced_mass = v.w > 0.0 ? 1.0/v.w : record[3].x;
    r->wx = w.x;
    r->wy = w.y;
    r->wz = w.z;
    if (surface)
    {
        dem_row_add_surface(facet, frames, drives, v, point, h, &g, r);
    }
    dem_geometry_motion(&g, 0, 0.5, r);
    if (surface)
    {
        /* the mean spin of the particle and the wall, as the host adds it */
        r->normal_spin += 0.5*((0.5*g.bx[0] - r->wx)*r->nx + (0.5*g.by[0] - r->wy)*r->ny +
                               (0.5*g.bz[0] - r->wz)*r->nz);
    }
    if (random)
    {
        r->pair_random = dem_random_unit(as_ulong(record[3].y), (ulong)(-1L - facet->number), 0, 0);
    }
    /* another facet has taken over the contact: along the old normal */
    r->is_primary = h > 0.5*DBL_MAX ? 0.0 : 1.0;
    r->distance = h > 0.5*DBL_MAX ? (x.x - point[0])*normal[0] + (x.y - point[1])*normal[1] +
                                        (x.z - point[2])*normal[2]
                                  : h;
    r->gap = r->distance - r->min_radius;
    *gathered = g;
}

/* A gap lengthens the lever arms; the distance changes along the normal of half a step ago. */
static void dem_row_add_gap(const struct dem_gathered *g, struct dem_contact_row *r)
{
    const double gap = r->gap > 0.0 ? r->gap : 0.0;
    const double bx = 0.5*g->bx[0], by = 0.5*g->by[0], bz = 0.5*g->bz[0];

    r->sx -= gap*(by*r->hz - bz*r->hy);
    r->sy -= gap*(bz*r->hx - bx*r->hz);
    r->sz -= gap*(bx*r->hy - by*r->hx);
    r->distance_rate = g->vx[0]*r->hx + g->vy[0]*r->hy + g->vz[0]*r->hz;
}

/* ---- what ends a run --------------------------------------------------------------------------- */

static void dem_row_check(constant struct dem_device_batch *b,
                          global struct dem_device_report *report, uint s, int with_wall,
                          const struct dem_contact_row *r, global const struct dem_facet *facet)
{
    const float fraction = (float)(0.5*r->overlap/r->min_radius);
    const double sum = r->fn + (r->fx + r->fy + r->fz);

    if (fraction > b->overlap && fraction > report->overlap)
    {
        atomic_max((volatile global uint *)&report->overlap, as_uint(fraction));
    }
    if (0.5*r->overlap >= b->overlap_limit*r->min_radius)
    {
        dem_report_event(report, DEM_DEVICE_OVERLAP, s);
    }
    if (!(sum*0.0 == 0.0))
    {
        dem_report_event(report, DEM_DEVICE_NOT_FINITE, s);
    }
    if (r->broke > 0.0)
    {
        dem_report_event(report, DEM_DEVICE_BROKE, s);
    }
    /* the centre was on the other side a step ago */
    if (with_wall && r->touching > 0.0 && r->vn*r->dt > r->min_radius - r->overlap &&
        (facet->shape == DEM_SHAPE_TRIANGLES || (facet->shape != DEM_SHAPE_PLANE && facet->outside)))
    {
        dem_report_event(report, DEM_DEVICE_CROSSED, s);
    }
}
