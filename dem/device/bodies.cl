/*
 * bodies.cl -- the kernel that ends a step: each particle sums its contact rows in the order of
 * partner ids, adds body forces (BODIES, a function that the host composes), is kicked, and drifts
 * into the next step; in the last step of a window it is kicked by half a step, and the sums are left for the
 * host. MOMENTS, PAST_TOUCHING: as of the interaction table; FLUID: there is one.
 *
 * The arithmetic is the host's (step/sum_contacts.c, step/sweep_bodies.c, step/drift.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/periodic_image.h"
#include "particles/turn.h"

/* Force and torque of the rows of a particle, in the order of partner ids; what they have dissipated,
   to `lost`. Moments follow when all lever arms have been added. */
static void dem_sum_rows(constant struct dem_device_batch *b, uint i, double radius,
                         global const uchar *restrict touch, global const double4 *restrict force,
                         global const double4 *restrict moment,
                         global const double4 *restrict energy, global const uint *restrict start,
                         global const uint *restrict entry, global double *restrict lost,
                         double f[3], double t[3])
{
    for (uint e = start[i]; e < start[i + 1]; e++)
    {
        const uint row = entry[e] >> 1;
        const double side = entry[e] & 1 ? -1.0 : 1.0;

        if (!(touch[row] & DEM_DEVICE_TOUCHES))
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
    }
#if MOMENTS
    for (uint e = start[i]; e < start[i + 1]; e++)
    {
        const uint row = entry[e] >> 1;
        const double side = entry[e] & 1 ? -1.0 : 1.0;

        if (touch[row] & DEM_DEVICE_TOUCHES)
        {
            const double4 m = moment[row];

            t[0] += side*m.x;
            t[1] += side*m.y;
            t[2] += side*m.z;
        }
    }
#endif
}

/* Contacts that a particle counts: of which it is the first partner. */
static uint dem_count_touching(uint i, global const uchar *restrict touch, global const double4 *restrict force,
                               global const uint *restrict start, global const uint *restrict entry)
{
    uint n = 0;

    for (uint e = start[i]; e < start[i + 1]; e++)
    {
        const uint row = entry[e] >> 1;

        n += !(entry[e] & 1) && touch[row] & DEM_DEVICE_TOUCHES && force[2*(size_t)row].w > 0.0;
    }
    return n;
}

/* 1 when a force of the scene acts on a particle (particles/applied_forces.c). */
static int dem_acts(global const struct dem_device_applied *f, global const long *ids,
                    constant struct dem_device_axes *axes, double time, double4 at, double4 rest)
{
    const double4 x = (double4)(dem_periodic_place(at.x, axes->min[0], axes->length[0]),
                                dem_periodic_place(at.y, axes->min[1], axes->length[1]),
                                dem_periodic_place(at.z, axes->min[2], axes->length[2]), 0.0);
    const long id = as_long(rest.y);
    uint from = f->first, to = f->end;

    if (!(time >= f->from && time < f->until && x.x >= f->min[0] && x.x < f->max[0] &&
          x.y >= f->min[1] && x.y < f->max[1] && x.z >= f->min[2] && x.z < f->max[2]) ||
        (f->material >= 0 && (uint)f->material != ((uint)as_ulong(rest.z) & 0xffffu)))
    {
        return 0;
    }
    while (from < to && ids[from + (to - from)/2] != id)
    {
        const uint middle = from + (to - from)/2;

        from = ids[middle] < id ? middle + 1 : from;
        to = ids[middle] < id ? to : middle;
    }
    return from < to || f->all;
}

/* The scene's forces on a particle, of all that act, to the row; torques [N m]. */
static void dem_apply(constant struct dem_device_batch *b, uint s,
                      global const struct dem_device_applied *applied, global const long *ids,
                      constant struct dem_device_axes *axes, double4 x, double4 v, double4 rest,
                      struct dem_body_row *r, double force[3], double torque[3])
{
    const double time = b->window_start + (double)(b->first + (int64_t)s)*b->dt;

    for (uint k = 0; k < b->applied && v.w > 0.0; k++)
    {
        const int acts = dem_acts(applied + k, ids, axes, time, x, rest);

        for (int m = 0; acts && m < 3; m++)
        {
            force[m] += applied[k].force[m];
            torque[m] += applied[k].torque[m];
        }
    }
    if (b->applied > 0)
    {
        r->fx += force[0];
        r->fy += force[1];
        r->fz += force[2];
    }
}

#if BALANCE && FLUID
/* What the fluid gives to a particle in this step, for the balance. */
static void dem_balance_impulses(struct dem_particle_balance *e, global const double *columns, uint n, uint i,
                                 const double impulse[3], const double spin_impulse[3])
{
    for (int k = 0; k < 3; k++)
    {
        e->drag_impulse[k] = impulse[k];
        e->carried[k] = VECTOR(CARRIED_OVER_IMPULSE, k);
#ifdef COLUMN_ANGULAR_IMPULSE
        e->spin_impulse[k] = spin_impulse[k];
#endif
    }
}
#endif

static void set_motion(struct dem_body_row *r, double4 v, double4 w)
{
    r->vx = v.x;
    r->vy = v.y;
    r->vz = v.z;
    r->wx = w.x;
    r->wy = w.y;
    r->wz = w.z;
}

kernel __attribute__((reqd_work_group_size(DEM_DEVICE_GROUP, 1, 1)))
void bodies(constant struct dem_device_batch *b, global struct dem_device_report *report, uint s,
            global double4 *restrict record, global const uchar *restrict touch,
            global const double4 *restrict force, global const double4 *restrict moment,
            global const double4 *restrict energy, global const uint *restrict start,
            global const uint *restrict entry, global double *restrict lost,
            constant struct dem_device_axes *axes, global double *restrict columns,
            global const double *restrict rates,
            global const struct dem_device_applied *restrict applied,
            global const long *restrict ids, global long *sums, global double4 *restrict contact_sums)
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
        /* the host has turned particles and advanced eddies before the first step */
        const int later = b->first + (int64_t)s > b->first_of_all;

#ifdef COLUMN_ORIENTATION
        global double *const turned =
            columns + (size_t)COLUMN_ORIENTATION*b->column + 4*(size_t)i;
        double turn_of[4] = {turned[0], turned[1], turned[2], turned[3]};

        dem_turn(w.x, w.y, w.z, 0.5*b->dt, turn_of);
        for (int k = 0; later && k < 4; k++)
        {
            turned[k] = turn_of[k];
        }
#endif
        double f[3] = {0.0, 0.0, 0.0}, t[3] = {0.0, 0.0, 0.0};
        double applied_force[3] = {0.0, 0.0, 0.0}, applied_torque[3] = {0.0, 0.0, 0.0};
        double impulse[3], spin_impulse[3];
        struct dem_body_row r;

        dem_sum_rows(b, i, x.w, touch, force, moment, energy, start, entry, lost, f, t);
        r.mass = rest.x;
        r.radius = x.w;
        r.fx = f[0];
        r.fy = f[1];
        r.fz = f[2];
        set_motion(&r, v, w);

        const int last = s == b->last;
        const double h = last ? 0.5*b->dt : b->dt;

#if BALANCE
        struct dem_particle_balance e = {.to = {b, report, sums, s}};

        dem_balance_particle(b, v, w, rest, f, t, &e);
#if !FLUID
        r.rx = r.ry = r.rz = 0.0;
#endif
#endif
#if FLUID || SCALARS
        const uint n = b->column;
#endif
#if SCALARS
        struct dem_particle_scalars q;

        dem_particle_scalars_begin(columns, n, i, b->over_window, rates, touch, start, entry, &q);
#endif
#if FLUID
        dem_fluid_begin(columns, n, i, b->over_window, &r);
#ifdef COLUMN_EDDY
        dem_fluid_eddy(columns, n, i, b->dt, later ? (ulong)(b->number + s) : 0, as_ulong(rest.y), &r);
#else
        (void)later;
#endif
        BODIES(BODY_ARGUMENTS);
        dem_apply(b, s, applied, ids, axes, x, v, rest, &r, applied_force, applied_torque);
        dem_fluid_kick(columns, n, i, h, &r, &v, impulse);
#else
        BODIES(BODY_ARGUMENTS);
        dem_apply(b, s, applied, ids, axes, x, v, rest, &r, applied_force, applied_torque);

        const double step = h*v.w;

        v.x += step*r.fx;
        v.y += step*r.fy;
        v.z += step*r.fz;
#endif
#ifdef COLUMN_ANGULAR_IMPULSE
        w.x = dem_fluid_turn(&VECTOR(ANGULAR_IMPULSE, 0), h, w.w, r.spin_drag, r.spin_drag_wx,
                             t[0], w.x, spin_impulse);
        w.y = dem_fluid_turn(&VECTOR(ANGULAR_IMPULSE, 1), h, w.w, r.spin_drag, r.spin_drag_wy,
                             t[1], w.y, spin_impulse + 1);
        w.z = dem_fluid_turn(&VECTOR(ANGULAR_IMPULSE, 2), h, w.w, r.spin_drag, r.spin_drag_wz,
                             t[2], w.z, spin_impulse + 2);
#else
        const double turn = h*w.w;

        w.x += turn*t[0];
        w.y += turn*t[1];
        w.z += turn*t[2];
#endif
#if BALANCE
#if FLUID
        dem_balance_impulses(&e, columns, n, i, impulse, spin_impulse);
#endif
        set_motion(&r, v, w);
        body_balance(&e, &r);
#endif
        if (b->applied > 0)
        {
            w.x += applied_torque[0]*w.w*h;
            w.y += applied_torque[1]*w.w*h;
            w.z += applied_torque[2]*w.w*h;
#if BALANCE
            dem_balance_applied(&e, applied_force, applied_torque, v, w);
#endif
        }
#if SCALARS
        if (dem_particle_scalars_end(columns, n, i, b->dt, rest.x, (uint)as_ulong(rest.z) & 0xffffu, &q))
        {
            dem_report_event(report, DEM_DEVICE_NOT_FINITE, s);
        }
#ifdef ENERGY_HEATED
        dem_exact_add(&e.to, ENERGY_HEAT_BODIES, h*q.heated);
        dem_exact_add(&e.to, ENERGY_HEAT_BODIES, -h*q.from_contacts);
#endif
#endif
        v.x = axes->flat[0] ? 0.0 : v.x;
        v.y = axes->flat[1] ? 0.0 : v.y;
        v.z = axes->flat[2] ? 0.0 : v.z;
        w.x = axes->flat[1] || axes->flat[2] ? 0.0 : w.x;
        w.y = axes->flat[2] || axes->flat[0] ? 0.0 : w.y;
        w.z = axes->flat[0] || axes->flat[1] ? 0.0 : w.z;
#if BALANCE
        dem_balance_drift(&e, v, w, rest.x, f, t);
#endif
        if (last)
        {
            contact_sums[2*(size_t)i] =
                (double4)(f[0], f[1], f[2], (double)dem_count_touching(i, touch, force, start, entry));
            contact_sums[2*(size_t)i + 1] = (double4)(t[0], t[1], t[2], 0.0);
        }
        else
        {
            x.x += (h*v.x + axes->round[0]) - axes->round[0];
            x.y += (h*v.y + axes->round[1]) - axes->round[1];
            x.z += (h*v.z + axes->round[2]) - axes->round[2];
        }
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

    for (uint m = 0; row < rows && !(touch[row] & DEM_DEVICE_TOUCHES) && m < columns; m++)
    {
        history[(size_t)m*rows + row] = 0.0;
    }
}
