/*
 * bodies.cl -- the kernel that ends a step: each particle sums its contact rows in the order of
 * partner ids, adds body forces (BODIES, a function that the host composes), is kicked, and drifts
 * into the next step. MOMENTS, PAST_TOUCHING: as of the interaction table; FLUID: there is one.
 *
 * The arithmetic is the host's (step/sum_contacts.c, step/sweep_bodies.c, step/drift.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */

/* 1 when the host would drop or blend one of two touching wall contacts, or share their springs:
   nearly parallel normals, one contact point, or the contact point of one on the other's facet. The
   limits are wider than walls/wall_touch.c and step/wall_springs.c have, so the host decides. */
static int dem_facets_interact(global const struct dem_facet *a, global const struct dem_facet *b,
                               global const struct dem_device_frame *frames, const double x[3],
                               double radius)
{
    const double near = 2e-7*radius, nearly_flat = 0.866;
    double point_a[3], normal_a[3], point_b[3], normal_b[3], apart[3], on[3], there[3];

    if (dem_wall_touch(a, frames, x, point_a, normal_a) >= radius ||
        dem_wall_touch(b, frames, x, point_b, normal_b) >= radius)
    {
        return 0;
    }
    dem_vec_minus(point_a, point_b, apart);
    return dem_vec_dot(normal_a, normal_b) > nearly_flat || dem_vec_norm(apart) < near ||
           fabs(dem_wall_touch(b, frames, point_a, on, there)) < near ||
           fabs(dem_wall_touch(a, frames, point_b, on, there)) < near;
}

/* Force and torque of the rows of a particle, in the order of partner ids; what they have dissipated,
   to `lost`. Moments follow when all lever arms have been added. Returns the number of wall rows with
   a force. */
static uint dem_sum_rows(constant struct dem_device_batch *b, uint i, double radius,
                         global const uchar *restrict touch, global const double4 *restrict force,
                         global const double4 *restrict moment,
                         global const double4 *restrict energy, global const uint *restrict start,
                         global const uint *restrict entry, global double *restrict lost,
                         double f[3], double t[3])
{
    uint walls = 0;

    for (uint e = start[i]; e < start[i + 1]; e++)
    {
        const uint row = entry[e] >> 1;
        const double side = entry[e] & 1 ? -1.0 : 1.0;

        if (!touch[row])
        {
            continue;
        }
        const double4 a = force[2*(size_t)row], c = force[2*(size_t)row + 1];
        const double lever = a.w - radius;

        f[0] += side*a.x;
        f[1] += side*a.y;
        f[2] += side*a.z;
        t[0] += lever*c.x;
        t[1] += lever*c.y;
        t[2] += lever*c.z;
#if PAST_TOUCHING
        lost[i] += (row >= b->walls ? 1.0 : 0.5)*energy[row].y;
#endif
        walls += row >= b->walls;
    }
#if MOMENTS
    for (uint e = start[i]; e < start[i + 1]; e++)
    {
        const uint row = entry[e] >> 1;
        const double side = entry[e] & 1 ? -1.0 : 1.0;

        if (touch[row])
        {
            const double4 m = moment[row];

            t[0] += side*m.x;
            t[1] += side*m.y;
            t[2] += side*m.z;
        }
    }
#endif
    return walls;
}

/* An event when two facets that a particle touches interact. Rows of walls are the last ones. */
static void dem_check_corners(constant struct dem_device_batch *b,
                              global struct dem_device_report *report, uint s, uint i,
                              const double x[3], double radius,
                              global const uint2 *restrict partners,
                              global const struct dem_facet *restrict facets,
                              global const struct dem_device_frame *restrict frames,
                              global const uchar *restrict touch,
                              global const uint *restrict start, global const uint *restrict entry)
{
    for (uint e = start[i + 1]; e > start[i] && entry[e - 1] >> 1 >= b->walls; e--)
    {
        const uint row = entry[e - 1] >> 1;

        for (uint d = e - 1; d > start[i] && entry[d - 1] >> 1 >= b->walls; d--)
        {
            const uint other = entry[d - 1] >> 1;

            if (touch[row] && touch[other] &&
                dem_facets_interact(facets + partners[row].y, facets + partners[other].y,
                                    frames + s*b->frames, x, radius))
            {
                dem_report_event(report, DEM_DEVICE_CORNER, s);
            }
        }
    }
}

kernel __attribute__((reqd_work_group_size(DEM_DEVICE_GROUP, 1, 1)))
void bodies(constant struct dem_device_batch *b, global struct dem_device_report *report, uint s,
            global double4 *restrict record, global const uint2 *restrict partners,
            global const struct dem_facet *restrict facets, global const uchar *restrict touch,
            global const double4 *restrict force, global const double4 *restrict moment,
            global const double4 *restrict energy, global const uint *restrict start,
            global const uint *restrict entry, global double *restrict lost,
            constant struct dem_device_axes *axes,
            global const struct dem_device_frame *restrict frames,
            global double *restrict columns)
{
    local uint fastest[DEM_DEVICE_GROUP];    /* bits: as integers, not-a-number is largest */
    const uint i = get_global_id(0), l = get_local_id(0);

    fastest[l] = 0;
    if (dem_used_up(b, report, s))
    {
        return;
    }
    if (i < b->particles)
    {
        double4 x = record[4*(size_t)i], v = record[4*(size_t)i + 1], w = record[4*(size_t)i + 2];
        const double4 rest = record[4*(size_t)i + 3];
        double f[3] = {0.0, 0.0, 0.0}, t[3] = {0.0, 0.0, 0.0};
        const double at[3] = {x.x, x.y, x.z};
        struct dem_body_row r;

        if (dem_sum_rows(b, i, x.w, touch, force, moment, energy, start, entry, lost, f, t) > 1)
        {
            dem_check_corners(b, report, s, i, at, x.w, partners, facets, frames, touch, start,
                              entry);
        }
        r.mass = rest.x;
        r.radius = x.w;
        r.fx = f[0];
        r.fy = f[1];
        r.fz = f[2];
        r.vx = v.x;
        r.vy = v.y;
        r.vz = v.z;
        r.wx = w.x;
        r.wy = w.y;
        r.wz = w.z;

        const double h = b->dt;

#if FLUID
        const uint n = b->particles;

        dem_fluid_begin(columns, n, i, b->over_window, &r);
        BODIES(&r);
        dem_fluid_kick(columns, n, i, h, &r, &v);
#else
        BODIES(&r);

        const double step = h*v.w;

        v.x += step*r.fx;
        v.y += step*r.fy;
        v.z += step*r.fz;
#endif
#ifdef COLUMN_ANGULAR_IMPULSE
        w.x = dem_fluid_turn(&VECTOR(ANGULAR_IMPULSE, 0), h, w.w, r.spin_drag, r.spin_drag_wx,
                             t[0], w.x);
        w.y = dem_fluid_turn(&VECTOR(ANGULAR_IMPULSE, 1), h, w.w, r.spin_drag, r.spin_drag_wy,
                             t[1], w.y);
        w.z = dem_fluid_turn(&VECTOR(ANGULAR_IMPULSE, 2), h, w.w, r.spin_drag, r.spin_drag_wz,
                             t[2], w.z);
#else
        const double turn = h*w.w;

        w.x += turn*t[0];
        w.y += turn*t[1];
        w.z += turn*t[2];
#endif
        v.x = axes->flat[0] ? 0.0 : v.x;
        v.y = axes->flat[1] ? 0.0 : v.y;
        v.z = axes->flat[2] ? 0.0 : v.z;
        w.x = axes->flat[1] || axes->flat[2] ? 0.0 : w.x;
        w.y = axes->flat[2] || axes->flat[0] ? 0.0 : w.y;
        w.z = axes->flat[0] || axes->flat[1] ? 0.0 : w.z;
        x.x += (h*v.x + axes->round[0]) - axes->round[0];
        x.y += (h*v.y + axes->round[1]) - axes->round[1];
        x.z += (h*v.z + axes->round[2]) - axes->round[2];
        record[4*(size_t)i] = x;
        record[4*(size_t)i + 1] = v;
        record[4*(size_t)i + 2] = w;
        fastest[l] = as_uint(convert_float_rtp(v.x*v.x + v.y*v.y + v.z*v.z));
    }
    dem_group_max(fastest, (global uint *)&report->fastest[s]);
}

/* Before the history is read: zero where surfaces are apart. */
kernel __attribute__((reqd_work_group_size(DEM_DEVICE_GROUP, 1, 1)))
void clear_apart(uint rows, uint columns, global const uchar *restrict touch,
                 global double *restrict history)
{
    const uint row = get_global_id(0);

    for (uint m = 0; row < rows && !touch[row] && m < columns; m++)
    {
        history[(size_t)m*rows + row] = 0.0;
    }
}
