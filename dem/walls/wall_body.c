/*
 * wall_body.c -- kicks and drifts of a wall that is moved by force.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/wall_body.h"
#include "core/memory.h"
#include "core/vec.h"
#include "walls/wall_motion.h"
#include "walls/wall_rotation.h"
#include <math.h>
#include <string.h>

void dem_wall_body_free(struct dem_wall_body *b)
{
    if (b)
    {
        dem_time_table_free(b->table);
        dem_time_table_free(b->rotation.table);
        dem_memory_free(b);
    }
}

void dem_wall_body_pose(const struct dem_wall_body *b, int before, struct dem_pose *p)
{
    const double *const q = before ? b->state.before : b->state.q;

    if (b->kind == DEM_WALL_BODY_HINGE)
    {
        dem_pose_rotate(b->origin, b->axis[0], q[0], p);
        return;
    }
    *p = dem_pose_identity;
    if (b->rotation.axes > 0)
    {
        dem_wall_rotation_pose(b, before, p);
    }
    for (int k = 0; k < b->axes; k++)
    {
        for (int a = 0; a < 3; a++)
        {
            p->shift[a] += q[k]*b->axis[k][a];
        }
    }
}

void dem_wall_body_centre(const struct dem_wall_body *b, double centre[3])
{
    const int turns = b->rotation.axes > 0;

    memcpy(centre, turns ? b->rotation.origin : b->origin, sizeof b->origin);
    for (int k = 0; k < b->axes && turns; k++)
    {
        for (int a = 0; a < 3; a++)
        {
            centre[a] += b->state.q[k]*b->axis[k][a];
        }
    }
}

/* Damping coefficient of a servo for steps of dt [s]. */
static double servo_damping(const struct dem_wall_body *b, double dt)
{
    const struct dem_wall_body_state *const s = &b->state;

    return b->damping >= 0.0 ? b->damping
                             : fmax(s->impedance, 1.5*(s->dashpot + 0.5*s->stiffness*dt));
}

void dem_wall_body_load(const struct dem_wall_body *b, double time, double load[DEM_TIME_TABLE_COLUMNS])
{
    memset(load, 0, DEM_TIME_TABLE_COLUMNS*sizeof *load);
    memcpy(load, b->state.loaded > 0.0 ? b->state.load : b->force, sizeof b->force);
    if (b->table && b->state.loaded <= 0.0)
    {
        dem_time_table_at(b->table, time - b->start, load);
    }
}

/* The given force along each axis, the weight included. */
static void given_force(const struct dem_wall_body *b, const struct dem_wall_body_kick *in,
                        double force[3])
{
    double given[DEM_TIME_TABLE_COLUMNS], weight[3], arm[3], torque[3];

    dem_wall_body_load(b, in->time, given);
    for (int a = 0; a < 3; a++)
    {
        weight[a] = b->weighs*in->gravity[a];
    }
    if (b->kind == DEM_WALL_BODY_FREE)
    {
        for (int k = 0; k < b->axes; k++)
        {
            force[k] = dem_vec_dot(given, b->axis[k]) + dem_vec_dot(weight, b->axis[k]);
        }
        return;
    }
    dem_vec_minus(in->centre, b->origin, arm);
    dem_vec_cross(arm, weight, torque);
    force[0] = given[0]*b->area + dem_vec_dot(torque, b->axis[0]);
}

/* ---- servo ----------------------------------------------------------------------------------- */

/* An error of the force, as a fraction of its target, that counts as near. */
static const double near_error = 0.1;

int dem_wall_body_is_near(const struct dem_wall_body *b, double target)
{
    return fabs(target + b->state.force[0]) < near_error*fabs(target);
}

/* Once after each sweep: two half kicks at the end of a window have the sums of the same one. */
static void set_servo_speed(struct dem_wall_body *b, double force, double dt)
{
    struct dem_wall_body_state *const s = &b->state;
    const double c = servo_damping(b, dt) + s->dashpot, most = b->max_speed,
                 wanted = force + s->dashpot*s->v[0];

    if (s->summed == DEM_WALL_BODY_SWEPT)
    {
        /* without contact c is 0, unless it is given */
        s->v[0] = fabs(wanted) < most*c ? wanted/c : wanted > 0.0 ? most : wanted < 0.0 ? -most : 0.0;
        s->summed = DEM_WALL_BODY_KICKED;
    }
}

static void kick_servo(struct dem_wall_body *b, double target, const struct dem_wall_body_kick *in)
{
    struct dem_wall_body_state *const s = &b->state;
    const double error = target + s->force[0];

    set_servo_speed(b, error + s->hold, in->dt);
    if (s->contacts == 0.0)
    {
        s->hold = s->height = s->near_time = 0.0;
    }
    else if (s->height > 0.0 && fabs(s->v[0]) < b->max_speed)
    {
        const double tau = 4.0*s->height/s->diameter*s->impedance/s->stiffness;

        if (s->near_time >= 0.25*tau)
        {
            s->near_time = INFINITY;
            s->hold += in->h*error/tau;
        }
        else
        {
            s->near_time = dem_wall_body_is_near(b, target) ? s->near_time + in->h : 0.0;
        }
    }
}

/* ---- mass ------------------------------------------------------------------------------------ */

/* 1 when a hinge leans on a stop in the direction of v. */
static int leans(const struct dem_wall_body *b, double v)
{
    return b->kind == DEM_WALL_BODY_HINGE
        && ((v < 0.0 && b->state.q[0] <= b->stops[0]) || (v > 0.0 && b->state.q[0] >= b->stops[1]));
}

static void kick_axis(struct dem_wall_body *b, int k, double force, double h,
                      struct dem_wall_body_work *w)
{
    double *const v = &b->state.v[k];
    const double c = fmax(b->damping, 0.0), f = b->state.force[k], m = b->mass, before = *v;
    const double wanted = (m*before + h*(force + f))/(m + c*h);
    const double after = leans(b, wanted) ? 0.0 : wanted, mean = 0.5*(before + after);

    *v = after;
    w->loads += h*force*mean;
    w->contacts += h*f*mean;
    w->lost += (h*c*after + (m + h*c)*(wanted - after))*mean;
}

void dem_wall_body_kick(struct dem_wall_body *b, const struct dem_wall_body_kick *in,
                        struct dem_wall_body_work *w)
{
    double force[3] = {0.0, 0.0, 0.0};

    if (in->rests)
    {
        w->lost += dem_wall_body_kinetic(b);
        memset(b->state.v, 0, sizeof b->state.v);
        memset(b->state.momentum, 0, sizeof b->state.momentum);
        return;
    }
    given_force(b, in, force);
    if (b->kind == DEM_WALL_BODY_SERVO)
    {
        kick_servo(b, force[0], in);
        return;
    }
    for (int k = 0; k < b->axes; k++)
    {
        kick_axis(b, k, force[k], in->h, w);
    }
    if (b->rotation.axes > 0)
    {
        dem_wall_rotation_kick(b, in, w);
    }
}

/* Without its rotation. */
static double kinetic(const struct dem_wall_body *b)
{
    return b->kind == DEM_WALL_BODY_SERVO ? 0.0 : 0.5*b->mass*dem_vec_dot(b->state.v, b->state.v);
}

void dem_wall_body_drift(struct dem_wall_body *b, double dt, struct dem_wall_body_work *w)
{
    struct dem_wall_body_state *const s = &b->state;
    const double before = kinetic(b);

    memcpy(s->before, s->q, sizeof s->q);
    for (int k = 0; k < b->axes; k++)
    {
        const double to = s->q[k] + dt*s->v[k];
        const double reached = b->kind == DEM_WALL_BODY_HINGE ? fmin(fmax(to, b->stops[0]), b->stops[1])
                                                              : to;

        s->v[k] = reached == to ? s->v[k] : (reached - s->q[k])/dt;
        s->q[k] = reached;
        s->free_path = s->contacts == 0.0 ? s->free_path + fabs(dt*s->v[k]) : 0.0;
    }
    w->lost += before - kinetic(b);
    if (b->rotation.axes > 0)
    {
        dem_wall_rotation_drift(b, dt);
    }
}

double dem_wall_body_kinetic(const struct dem_wall_body *b)
{
    return kinetic(b) + (b->rotation.axes > 0 ? dem_wall_rotation_kinetic(b) : 0.0);
}
