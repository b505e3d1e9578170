/*
 * wall_motion.c -- poses and displacements per step of prescribed wall motions, in closed form.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/wall_motion.h"
#include "core/vec.h"
#include <float.h>
#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979324;

/* Sine and cosine with + - * only, after an exact remainder, so that they have the same bits with
   any C library. Taylor series: on |x| <= pi/4 the remainder after these terms is below 1e-18. pi/2
   is split into two parts of which the first has 33 bits, so that its multiples are exact. The
   value of pi in fmod has a relative error of 4e-17, less than the round-off of the angle. */
static void sine_cosine(double angle, double *sine, double *cosine)
{
    static const double main = 1.57079632673412561417, rest = 6.07710050650619224932e-11;
    const double reduced = fmod(angle, 2.0*pi), quarter = floor(reduced/(0.5*pi) + 0.5);
    const double x = reduced - quarter*main - quarter*rest, square = x*x;
    double s = 0.0, c = 0.0;

    for (int k = 17; k > 1; k -= 2)
    {
        s = (1.0 + s)*(-square/(k*(k - 1)));
        c = (1.0 + c)*(-square/((k + 1)*k));
    }
    c = (1.0 + c)*(-square/2.0);
    s = x + x*s;
    c = 1.0 + c;
    switch (((int)quarter + 8)%4)
    {
    case 0: *sine = s, *cosine = c; break;
    case 1: *sine = c, *cosine = -s; break;
    case 2: *sine = -s, *cosine = -c; break;
    default: *sine = -c, *cosine = s; break;
    }
}

double dem_motion_duration(const struct dem_motion *m)
{
    return m->stage[0] || m->stage[1] ? m->longest : m->end - m->start;
}

double dem_motion_time(const struct dem_motion *m, double time)
{
    return fmax(fmin(time, m->end) - m->start, 0.0);
}

/* Part of the step that ends at `time` during which the wall was in motion [s]. */
static double active_time(const struct dem_motion *m, double time, double dt)
{
    return fmax(dt - fmax(m->start - (time - dt), 0.0) - fmax(time - m->end, 0.0), 0.0);
}

/* ---- poses ----------------------------------------------------------------------------------- */

void dem_pose_rotate(const double origin[3], const double axis[3], double angle, struct dem_pose *p)
{
    const double *const k = axis;
    double s, c, moved[3];

    sine_cosine(angle, &s, &c);
    for (int a = 0; a < 3; a++)
    {
        const int b = (a + 1)%3, d = (a + 2)%3;

        p->rotation[a][a] = c + (1.0 - c)*k[a]*k[a];
        p->rotation[a][b] = (1.0 - c)*k[a]*k[b] - s*k[d];
        p->rotation[a][d] = (1.0 - c)*k[a]*k[d] + s*k[b];
    }
    dem_pose_direction(p, origin, moved);
    dem_vec_minus(origin, moved, p->shift);
}

void dem_motion_pose(const struct dem_motion *m, double time, struct dem_pose *p)
{
    const double in_motion = dem_motion_time(m, time);
    double s = 0.0, c;

    *p = (struct dem_pose){.rotation = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    if (m->kind == DEM_MOTION_ROTATION)
    {
        dem_pose_rotate(m->origin, m->axis, m->omega*in_motion, p);
    }
    else if (m->kind == DEM_MOTION_OSCILLATION)
    {
        sine_cosine(2.0*pi*m->frequency*in_motion + m->phase, &s, &c);
    }
    for (int k = 0; k < 3 && m->kind != DEM_MOTION_ROTATION; k++)
    {
        p->shift[k] =
            m->kind == DEM_MOTION_TRANSLATION ? m->velocity[k]*in_motion : m->amplitude[k]*s;
    }
}

void dem_motion_velocity(const struct dem_motion *m, const double x[3], double v[3])
{
    double d[3], around[3];

    dem_vec_minus(x, m->origin, d);
    dem_vec_cross(m->axis, d, around);
    for (int k = 0; k < 3; k++)
    {
        v[k] = m->kind == DEM_MOTION_ROTATION      ? m->omega*around[k]
               : m->kind == DEM_MOTION_OSCILLATION ? 2.0*pi*m->frequency*m->amplitude[k]
                                                   : m->velocity[k];
    }
}

/* Steps in a period. At 60 the work of a wall that shakes grains is within 1 %: the error falls as
   34/N^2. A round wall that rotates seems to move along its normal by pi/N of its surface speed,
   the chord of a point of it; at 360 by 0.9 %. */
static const double oscillation_steps = 60.0, rotation_steps = 360.0;

double dem_motion_time_limit(const struct dem_motion *m, const char **why)
{
    const int rotates = m->kind == DEM_MOTION_ROTATION;
    const double rate = rotates                              ? fabs(m->omega)/(2.0*pi)
                        : m->kind == DEM_MOTION_OSCILLATION ? m->frequency
                                                             : 0.0;

    *why = rotates ? "1/360 of a revolution of wall " : "1/60 of the period of wall ";
    return rate > 0.0 && m->end > 0.0
               ? 1.0/(rate*(rotates ? rotation_steps : oscillation_steps))
               : DBL_MAX;
}

/* ---- displacements per step ------------------------------------------------------------------ */

/* sin(b) - sin(a) = 2 cos((a + b)/2) sin((b - a)/2): avoids cancellation. */
static void displacement_oscillation(const struct dem_motion *m, double time, double dt,
                                     struct dem_wall_displacement *s)
{
    const double moved = active_time(m, time, dt), turns = 2.0*pi*m->frequency;
    double half, middle, unused, rate = 0.0;

    sine_cosine(0.5*turns*moved, &half, &unused);
    sine_cosine(turns*(dem_motion_time(m, time) - 0.5*moved) + m->phase, &unused, &middle);
    if (dt > 0.0)
    {
        rate = 2.0*middle*half/dt;
    }
    else if (time >= m->start && time <= m->end)
    {
        rate = turns*middle;
    }
    for (int k = 0; k < 3; k++)
    {
        s->velocity[k] = m->amplitude[k]*rate;
    }
}

static void displacement_rotation(const struct dem_motion *m, double moved, double fraction,
                                  double dt, struct dem_wall_displacement *s)
{
    double half_sine, half_cosine;

    memcpy(s->origin, m->origin, sizeof s->origin);
    memcpy(s->axis, m->axis, sizeof s->axis);
    sine_cosine(0.5*m->omega*moved, &half_sine, &half_cosine);
    s->sine = 2.0*half_sine*half_cosine;
    s->versine = 2.0*half_sine*half_sine;
    s->sine_rate = dt > 0.0 ? s->sine/dt : m->omega*fraction;
    s->versine_rate = dt > 0.0 ? s->versine/dt : 0.0;
}

void dem_motion_displacement(const struct dem_motion *m, double time, double dt,
                             struct dem_wall_displacement *s)
{
    const double moved = active_time(m, time, dt),
                 now = time >= m->start && time <= m->end ? 1.0 : 0.0;
    const double fraction = dt > 0.0 ? moved/dt : now;

    *s = (struct dem_wall_displacement){.sine = 0.0};
    if (m->kind == DEM_MOTION_TRANSLATION)
    {
        for (int k = 0; k < 3; k++)
        {
            s->velocity[k] = m->velocity[k]*fraction;
        }
    }
    else if (m->kind == DEM_MOTION_OSCILLATION)
    {
        displacement_oscillation(m, time, dt, s);
    }
    else if (m->kind == DEM_MOTION_ROTATION)
    {
        displacement_rotation(m, moved, fraction, dt, s);
    }
}

/* ---- reference frames ------------------------------------------------------------------------ */

void dem_pose_product(const struct dem_pose *a, const struct dem_pose *b, struct dem_pose *product)
{
    for (int i = 0; i < 3; i++)
    {
        for (int k = 0; k < 3; k++)
        {
            product->rotation[i][k] = a->rotation[i][0]*b->rotation[0][k]
                                    + a->rotation[i][1]*b->rotation[1][k]
                                    + a->rotation[i][2]*b->rotation[2][k];
        }
    }
    dem_pose_point(a, b->shift, product->shift);
}

void dem_pose_inverse(const struct dem_pose *p, struct dem_pose *inverse)
{
    for (int i = 0; i < 3; i++)
    {
        for (int k = 0; k < 3; k++)
        {
            inverse->rotation[i][k] = p->rotation[k][i];
        }
    }
    for (int k = 0; k < 3; k++)
    {
        inverse->shift[k] = -dem_vec_dot(inverse->rotation[k], p->shift);
    }
}
