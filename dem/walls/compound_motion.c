/*
 * compound_motion.c -- poses, displacements and limits of motions one after the other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/compound_motion.h"
#include "core/hash.h"
#include "core/memory.h"
#include "core/vec.h"
#include <float.h>
#include <math.h>
#include <string.h>

void dem_compound_motion_free(struct dem_compound_motion *c)
{
    for (int k = 0; c && k < c->parts; k++)
    {
        dem_time_table_free(c->part[k].table);
    }
    if (c)
    {
        dem_wall_body_free(c->body);
        dem_memory_free(c);
    }
}

/* ---- poses ----------------------------------------------------------------------------------- */

static void part_pose(const struct dem_motion_part *p, double time, struct dem_pose *pose)
{
    const struct dem_motion *const m = &p->motion;
    double at[DEM_TIME_TABLE_COLUMNS];

    if (!p->table)
    {
        dem_motion_pose(m, time, pose);
        return;
    }
    dem_time_table_at(p->table, dem_motion_time(m, time), at);
    dem_pose_rotate(m->origin, m->axis, at[3], pose);
    for (int k = 0; k < 3; k++)
    {
        pose->shift[k] += at[k];
    }
}

/* before: with the displacement of the body a step ago. */
static void pose_with(const struct dem_compound_motion *c, double time, int before,
                      struct dem_pose *pose)
{
    struct dem_pose next, inner = dem_pose_identity;

    *pose = dem_pose_identity;
    for (int k = 0; k < c->parts + (c->body != NULL); k++)
    {
        if (k < c->parts)
        {
            part_pose(&c->part[k], time, &next);
        }
        else
        {
            dem_wall_body_pose(c->body, before, &next);
        }
        dem_pose_product(&next, &inner, pose);
        inner = *pose;
    }
}

void dem_compound_motion_pose(const struct dem_compound_motion *c, double time, struct dem_pose *p)
{
    pose_with(c, time, 0, p);
}

/* x - x(t - dt) = (I - R^T) (x - s) + s - s(t - dt),  I - R^T = sin K - (1 - cos) K K */
void dem_compound_motion_displacement(const struct dem_compound_motion *c, double time, double dt,
                                      struct dem_wall_displacement *d)
{
    struct dem_pose now, before, turn, back;

    *d = (struct dem_wall_displacement){.sine = 0.0};
    pose_with(c, time, 0, &now);
    pose_with(c, time - dt, 1, &before);
    dem_pose_inverse(&before, &back);
    dem_pose_product(&now, &back, &turn);
    for (int k = 0; k < 3; k++)
    {
        d->axis[k] = 0.5*(turn.rotation[(k + 2)%3][(k + 1)%3] - turn.rotation[(k + 1)%3][(k + 2)%3]);
        d->origin[k] = now.shift[k];
        d->velocity[k] = (now.shift[k] - before.shift[k])/dt;
    }
    d->sine = dem_vec_norm(d->axis);
    for (int k = 0; k < 3 && d->sine > 0.0; k++)
    {
        d->axis[k] /= d->sine;
    }
    d->versine = d->sine*d->sine/(1.0 + sqrt(fmax(1.0 - d->sine*d->sine, 0.0)));
    d->sine_rate = d->sine/dt;
    d->versine_rate = d->versine/dt;
}

/* ---- limits ---------------------------------------------------------------------------------- */

static void add_part_velocity(const struct dem_motion_part *p, const double x[3], double v[3])
{
    struct dem_motion turn = {.kind = DEM_MOTION_ROTATION};
    double rate[DEM_TIME_TABLE_COLUMNS] = {0.0}, own[3];

    if (p->table)
    {
        dem_time_table_rates(p->table, rate);
        memcpy(turn.origin, p->motion.origin, sizeof turn.origin);
        memcpy(turn.axis, p->motion.axis, sizeof turn.axis);
        turn.omega = rate[3];
    }
    dem_motion_velocity(p->table ? &turn : &p->motion, x, own);
    for (int k = 0; k < 3; k++)
    {
        v[k] += fabs(own[k]) + rate[k];
    }
}

void dem_compound_motion_velocity(const struct dem_compound_motion *c, const double x[3], double v[3])
{
    memset(v, 0, 3*sizeof *v);
    for (int k = 0; k < c->parts; k++)
    {
        add_part_velocity(&c->part[k], x, v);
    }
    for (int k = 0; k < 3 && c->body && c->body->kind == DEM_WALL_BODY_SERVO; k++)
    {
        v[k] += fabs(c->body->max_speed*c->body->axis[0][k]);
    }
}

double dem_compound_motion_speed(const struct dem_compound_motion *c, const double (*box)[3])
{
    double largest = 0.0;

    for (int k = 0; k < 8; k++)
    {
        const double x[3] = {box[k & 1][0], box[k >> 1 & 1][1], box[k >> 2][2]};
        double v[3];

        dem_compound_motion_velocity(c, x, v);
        largest = fmax(largest, dem_vec_norm(v));
    }
    return largest;
}

/* Steps between two rows of a table, and in a revolution. */
static const double row_steps = 4.0, rotation_steps = 360.0;

static double part_time_limit(const struct dem_motion_part *p, const char **why)
{
    const double turn = 6.28318530717958648;
    double rate[DEM_TIME_TABLE_COLUMNS];

    if (!p->table)
    {
        return dem_motion_time_limit(&p->motion, why);
    }
    dem_time_table_rates(p->table, rate);
    const double rows = dem_time_table_shortest(p->table)/row_steps,
                 turns = rate[3] > 0.0 ? turn/(rotation_steps*rate[3]) : DBL_MAX;

    *why = rows < turns ? "1/4 of the time between two rows of the motion of wall "
                        : "1/360 of a revolution of wall ";
    return fmin(rows, turns);
}

double dem_compound_motion_time_limit(const struct dem_compound_motion *c, const char **why)
{
    double least = DBL_MAX;

    for (int k = 0; k < c->parts; k++)
    {
        const char *criterion;
        const double limit = part_time_limit(&c->part[k], &criterion);

        *why = limit < least ? criterion : *why;
        least = fmin(least, limit);
    }
    return least;
}

int dem_compound_motion_dense_rows(const struct dem_compound_motion *c, double step, double time[2])
{
    for (int k = 0; k < c->parts; k++)
    {
        const struct dem_time_table *const t = c->part[k].table;

        for (size_t i = 0; t && i + 1 < t->rows; i++)
        {
            if (t->row[i + 1].time - t->row[i].time < row_steps*step*(1.0 - 1e-9))
            {
                time[0] = t->row[i].time;
                time[1] = t->row[i + 1].time;
                return 1;
            }
        }
    }
    return 0;
}

static const double *part_axis(const struct dem_motion_part *p)
{
    double rate[DEM_TIME_TABLE_COLUMNS] = {0.0};

    if (p->table)
    {
        dem_time_table_rates(p->table, rate);
    }
    return p->motion.kind == DEM_MOTION_ROTATION || rate[3] > 0.0 ? p->motion.axis : NULL;
}

/* An axis of the body; if it rotates about all, one that is not this coordinate axis. */
static const double *body_axis(const struct dem_wall_body *b, int axis)
{
    static const double unit[2][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};

    return b->rotation.axes == 3            ? unit[axis == 0]
           : b->rotation.axes == 1          ? b->rotation.axis
           : b->kind == DEM_WALL_BODY_HINGE ? b->axis[0]
                                            : NULL;
}

const double *dem_compound_motion_leans(const struct dem_compound_motion *c, int axis, int *rotates)
{
    const double *leaning = NULL;

    *rotates = 0;
    for (int k = 0; k < c->parts + (c->body != NULL); k++)
    {
        const double *const about = k < c->parts ? part_axis(&c->part[k]) : body_axis(c->body, axis);

        *rotates |= about != NULL;
        leaning = about && (about[(axis + 1)%3] != 0.0 || about[(axis + 2)%3] != 0.0) ? about
                                                                                      : leaning;
    }
    return leaning;
}

const struct dem_motion *dem_compound_motion_turns(const struct dem_compound_motion *c)
{
    double rate[DEM_TIME_TABLE_COLUMNS];

    if (c->parts != 1 || c->body || !c->part[0].table)
    {
        return NULL;
    }
    dem_time_table_rates(c->part[0].table, rate);
    return rate[0] + rate[1] + rate[2] > 0.0 || !(rate[3] > 0.0) ? NULL : &c->part[0].motion;
}

/* ---- identity -------------------------------------------------------------------------------- */

/* Of members, as the struct has padding. */
static void hash_formula(struct dem_hash *hash, const struct dem_motion *m)
{
    const double kind = m->kind;

    dem_hash_bytes(hash, &kind, sizeof kind);
    dem_hash_bytes(hash, &m->start, sizeof m->start);
    dem_hash_bytes(hash, &m->end, sizeof m->end);
    dem_hash_bytes(hash, m->velocity, sizeof m->velocity);
    dem_hash_bytes(hash, m->amplitude, sizeof m->amplitude);
    dem_hash_bytes(hash, &m->frequency, sizeof m->frequency);
    dem_hash_bytes(hash, &m->phase, sizeof m->phase);
    dem_hash_bytes(hash, m->origin, sizeof m->origin);
    dem_hash_bytes(hash, m->axis, sizeof m->axis);
    dem_hash_bytes(hash, &m->omega, sizeof m->omega);
}

static uint64_t hash_body(const struct dem_wall_body *b)
{
    const double kind[3] = {b->kind, b->axes, b->rotation.axes};
    struct dem_hash hash;

    dem_hash_start(&hash, 'b');
    dem_hash_bytes(&hash, kind, sizeof kind);
    dem_hash_bytes(&hash, b->axis, (size_t)b->axes*sizeof *b->axis);
    dem_hash_bytes(&hash, b->origin, sizeof b->origin);
    dem_hash_bytes(&hash, b->rotation.axis, sizeof b->rotation.axis);
    dem_hash_bytes(&hash, b->rotation.centre, sizeof b->rotation.centre);
    return dem_hash_value(&hash);
}

struct dem_motion_hash dem_compound_motion_hash(const struct dem_compound_motion *c)
{
    struct dem_hash formulas, tables;

    dem_hash_start(&formulas, 'm');
    dem_hash_start(&tables, 't');
    for (int k = 0; k < c->parts; k++)
    {
        const uint64_t rows = c->part[k].table ? dem_time_table_hash(c->part[k].table) : 0;

        hash_formula(&formulas, &c->part[k].motion);
        dem_hash_bytes(&tables, &rows, sizeof rows);
    }
    return (struct dem_motion_hash){dem_hash_value(&formulas), dem_hash_value(&tables),
                                    c->body ? hash_body(c->body) : 0};
}
