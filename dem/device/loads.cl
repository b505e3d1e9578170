/*
 * loads.cl -- the impulse that particles give to each wall in a step, as wall_statistics.c sums it: in
 * exact sums (core/sum.h), so the order of the additions has no effect. FACETS: contacts from facets.cl;
 * MOMENTS: rows have some.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma OPENCL EXTENSION cl_khr_int64_base_atomics : enable
#include "core/sum_digits.h"
#include "particles/periodic_image.h"

/* A load's six numbers to the six sums of a wall. */
static void dem_add_load(global long *sums, const double load[6])
{
    for (int k = 0; k < 6; k++)
    {
        struct dem_sum_digits d;

        if (!dem_sum_digits_of(load[k], &d))
        {
            continue;    /* an event of the row */
        }
        for (int m = 0; m < 3; m++)
        {
            if (d.digit[m])
            {
                atom_add((volatile global long *)sums + k*DEM_DEVICE_SUM + d.first + m, d.digit[m]);
            }
        }
    }
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
                       constant struct dem_device_axes *axes)
{
    const uint i = get_global_id(0);

    if (dem_used_up(b, report, s) || i >= b->particles)
    {
        return;
    }
    for (uint e = start[i + 1]; e > start[i] && entry[e - 1] >> 1 >= b->walls; e--)
    {
        const uint row = entry[e - 1] >> 1;
        global const struct dem_facet *const facet = facets + partners[row].y;
        global long *const to = sums + (size_t)(facet->largest >> 2)*6*DEM_DEVICE_SUM;

        if (!touch[row])
        {
            continue;
        }
        const double4 f = force[2*(size_t)row];
        double point[3], load[6] = {-b->dt*f.x, -b->dt*f.y, -b->dt*f.z};

        if (f.x != 0.0 || f.y != 0.0 || f.z != 0.0)
        {
#if FACETS
            const double4 p = contacts[2*(size_t)(row - b->walls)];

            point[0] = p.x;
            point[1] = p.y;
            point[2] = p.z;
#else
            const double4 x = record[4*(size_t)i];
            const double at[3] = {x.x, x.y, x.z};
            double normal[3];

            dem_wall_touch(facet, frames + s*b->frames, at, point, normal);
#endif
            for (int k = 0; k < 3; k++)
            {
                point[k] = dem_periodic_place(point[k], axes->min[k], axes->length[k]);
            }
            dem_vec_cross(point, load, load + 3);
            dem_add_load(to, load);
        }
#if MOMENTS
        const double4 m = moment[row];
        const double more[6] = {0.0, 0.0, 0.0, -b->dt*m.x, -b->dt*m.y, -b->dt*m.z};

        dem_add_load(to, more);
#endif
    }
}
