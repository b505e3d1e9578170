/*
 * loads.cl -- what walls and particles exchange in a step, in exact sums (sums.cl): the impulse that
 * particles give to each wall, as wall_statistics.c sums it, and the work of walls that move. FACETS:
 * contacts from facets.cl; MOMENTS: rows have some; BALANCE: there is an energy balance.
 *
 * Wall k has the sums DEM_DEVICE_WALL_SUMS k and on: force, moment about the origin, work.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/periodic_image.h"

/* Contact point and normal of a row. */
static void dem_row_point(constant struct dem_device_batch *b, uint s, uint row, double4 x,
                          global const struct dem_facet *restrict facet,
                          global const struct dem_device_frame *restrict frames,
                          global const double4 *restrict contacts, double point[3], double normal[3])
{
#if FACETS
    const double4 p = contacts[2*(size_t)(row - b->walls)],
                  n = contacts[2*(size_t)(row - b->walls) + 1];

    vstore3(p.xyz, 0, point);
    vstore3(n.xyz, 0, normal);
#else
    const double at[3] = {x.x, x.y, x.z};

    dem_wall_touch(facet, frames + s*b->frames, at, point, normal);
#endif
}

/* The impulse of a force f on the particle, and a moment m, on its wall. */
static void dem_add_load(const struct dem_exact_sums *to, uint sum, double4 f, double4 m,
                         const double point[3], constant struct dem_device_axes *axes)
{
    const double dt = to->step == to->batch->last ? 0.5*to->batch->dt : to->batch->dt;
    double load[6] = {-dt*f.x, -dt*f.y, -dt*f.z}, at[3];

    for (int k = 0; k < 3; k++)
    {
        at[k] = dem_periodic_place(point[k], axes->min[k], axes->length[k]);
    }
    dem_vec_cross(at, load, load + 3);
    for (int k = 0; k < 6 && (f.x != 0.0 || f.y != 0.0 || f.z != 0.0); k++)
    {
        dem_exact_add(to, sum + (uint)k, load[k]);
    }
    dem_exact_add(to, sum + 3, -dt*m.x);
    dem_exact_add(to, sum + 4, -dt*m.y);
    dem_exact_add(to, sum + 5, -dt*m.z);
}

/* The work of the wall on the particle in half of a drift. */
static void dem_add_wall_work(const struct dem_exact_sums *to, uint sum, double4 f, double4 m,
                              const double velocity[3], const double spin[3])
{
    const double force[3] = {f.x, f.y, f.z}, moment[3] = {m.x, m.y, m.z};
    const double turning = MOMENTS ? dem_vec_dot(moment, spin) : 0.0,
                 work = (dem_vec_dot(force, velocity) + turning)*(0.5*to->batch->dt);

    dem_exact_add(to, sum + 6, to->batch->loads ? work : 0.0);
#if BALANCE
    dem_exact_add(to, ENERGY_WALLS, work);
#endif
}

kernel void wall_loads(constant struct dem_device_batch *b, global struct dem_device_report *report,
                       uint s, global const double4 *restrict record,
                       global const uint2 *restrict partners,
                       global const struct dem_facet *restrict facets,
                       global const struct dem_device_frame *restrict frames,
                       global const uint *restrict start, global const uint *restrict entry,
                       global const uchar *restrict touch, global const double4 *restrict force,
                       global const double4 *restrict moment,
                       global const double4 *restrict contacts, global long *sums,
                       constant struct dem_device_axes *axes,
                       global const struct dem_wall_drive *restrict drives)
{
    const struct dem_exact_sums to = {b, report, sums, s};
    const uint i = get_global_id(0);

    if (dem_used_up(b, report, s) || i >= b->particles)
    {
        return;
    }
    for (uint e = start[i + 1]; e > start[i] && entry[e - 1] >> 1 >= b->walls; e--)
    {
        const uint row = entry[e - 1] >> 1;
        global const struct dem_facet *const facet = facets + partners[row].y;
        const uint sum = (facet->largest >> 2)*DEM_DEVICE_WALL_SUMS;
        double point[3], normal[3], velocity[3], spin[3];

        if (!(touch[row] & DEM_DEVICE_TOUCHES))
        {
            continue;
        }
        const double4 f = force[2*(size_t)row], m = MOMENTS ? moment[row] : (double4)(0.0);

        dem_row_point(b, s, row, record[4*(size_t)i], facet, frames, contacts, point, normal);
        if (b->loads)
        {
            dem_add_load(&to, sum, f, m, point, axes);
        }
        for (uint ahead = 0; b->work && ahead < 2; ahead++)
        {
            dem_wall_motion(facet, frames + (s + ahead)*b->frames, drives, (int)ahead, point, normal,
                            velocity, spin);
            dem_add_wall_work(&to, sum, f, m, velocity, spin);
        }
    }
}
