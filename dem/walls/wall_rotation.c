/*
 * wall_rotation.c -- kicks and drifts of the rotation of a free wall (formulas: wall_rotation.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/wall_rotation.h"
#include "core/vec.h"
#include "particles/clump.h"
#include "particles/principal_axes.h"
#include "walls/wall_motion.h"
#include <math.h>
#include <string.h>

/* ---- set-up ---------------------------------------------------------------------------------- */

/* out = T in */
static void apply(const double T[3][3], const double in[3], double out[3])
{
    for (int k = 0; k < 3; k++)
    {
        out[k] = dem_vec_dot(T[k], in);
    }
}

/* The tensor in space: B T B^T. */
static void tensor_in_space(const struct dem_wall_rotation *t, const struct dem_pose *base, double A[3][3])
{
    for (int i = 0; i < 9; i++)
    {
        double row[3];

        apply(t->tensor, base->rotation[i%3], row);
        A[i/3][i%3] = dem_vec_dot(base->rotation[i/3], row);
    }
}

void dem_wall_rotation_prepare(struct dem_wall_rotation *t, const struct dem_pose *base)
{
    double A[3][3], R[3][3], about[3];

    tensor_in_space(t, base, A);
    dem_pose_point(base, t->centre, t->origin);
    apply((const double (*)[3])A, t->axis, about);
    memset(t->principal, 0, sizeof t->principal);
    t->principal[0] = 1.0;
    if (t->axes == 3)
    {
        dem_principal_axes(A, R, t->principal);
    }
    for (int k = 0; k < 3; k++)
    {
        t->inertia[k] = t->axes == 3 ? A[k][k] : dem_vec_dot(about, t->axis);
    }
}

void dem_wall_rotation_start(struct dem_wall_body *b)
{
    apply((const double (*)[3])b->rotation.tensor, b->rotation.spin, b->state.momentum);
    for (int k = 0; k < 3 && b->rotation.axes == 1; k++)
    {
        b->state.momentum[k] =
            dem_vec_dot(b->rotation.spin, b->rotation.axis)*b->rotation.inertia[0]*b->rotation.axis[k];
    }
}

int dem_wall_rotation_impossible(const struct dem_wall_rotation *t)
{
    static const double rounded = 0.01;    /* of numbers that were printed with three digits */
    const double *const I = t->inertia;
    const double half = 0.5*(I[0] + I[1] + I[2]);
    int bad = 0;

    for (int k = 0; k < 3; k++)
    {
        bad |= !(I[k] > 0.0) || I[k] > half*(1.0 + rounded);
    }
    return bad;
}

double dem_wall_rotation_least_inertia(const struct dem_wall_rotation *t)
{
    return fmin(t->inertia[0], fmin(t->inertia[1], t->inertia[2]));
}

/* ---- motion ---------------------------------------------------------------------------------- */

/* The wall as a rigid body of the particles. */
static void as_clump(const struct dem_wall_body *b, struct dem_clump *c)
{
    *c = (struct dem_clump){.mass = b->mass};
    memcpy(c->inertia, b->rotation.inertia, sizeof c->inertia);
    memcpy(c->momentum, b->state.momentum, sizeof c->momentum);
    dem_clump_product(b->state.rotation, b->rotation.principal, c->q);
}

void dem_wall_rotation_pose(const struct dem_wall_body *b, int before, struct dem_pose *p)
{
    const double *const q = before ? b->state.rotation_before : b->state.rotation;
    double turned[3];

    for (int k = 0; k < 3; k++)
    {
        const double unit[3] = {k == 0, k == 1, k == 2};

        dem_clump_rotate(q, unit, turned);
        for (int a = 0; a < 3; a++)
        {
            p->rotation[a][k] = turned[a];
        }
    }
    dem_clump_rotate(q, b->rotation.origin, turned);
    dem_vec_minus(b->rotation.origin, turned, p->shift);
}

/* v, or with one axis its component along it. */
static void along(const struct dem_wall_rotation *t, const double v[3], double out[3])
{
    const double size = dem_vec_dot(v, t->axis);

    for (int k = 0; k < 3; k++)
    {
        out[k] = t->axes == 1 ? size*t->axis[k] : v[k];
    }
}

void dem_wall_rotation_kick(struct dem_wall_body *b, const struct dem_wall_body_kick *in,
                        struct dem_wall_body_work *w)
{
    double table[DEM_TIME_TABLE_COLUMNS] = {b->rotation.torque[0], b->rotation.torque[1], b->rotation.torque[2]};
    double given[3], contacts[3], before[3], drag[3] = {0.0, 0.0, 0.0}, mean[3], kicked[3], body[3];
    const double h = in->h, c = b->rotation.damping;
    struct dem_clump as;

    if (b->rotation.table)
    {
        dem_time_table_at(b->rotation.table, in->time - b->start, table);
    }
    along(&b->rotation, table, given);
    along(&b->rotation, b->state.torque, contacts);
    as_clump(b, &as);
    dem_clump_spin(&as, before);
    for (int k = 0; k < 3; k++)
    {
        kicked[k] = b->state.momentum[k] + h*(given[k] + contacts[k]);
    }
    if (c > 0.0)
    {
        dem_clump_rotate_back(as.q, kicked, body);
        for (int k = 0; k < 3; k++)
        {
            body[k] *= c/(as.inertia[k] + c*h);
        }
        dem_clump_rotate(as.q, body, drag);    /* c w+ */
    }
    for (int k = 0; k < 3; k++)
    {
        as.momentum[k] = b->state.momentum[k] = kicked[k] - h*drag[k];
    }
    dem_clump_spin(&as, mean);
    for (int k = 0; k < 3; k++)
    {
        mean[k] = 0.5*(before[k] + mean[k]);
    }
    w->loads += h*dem_vec_dot(given, mean);
    w->contacts += h*dem_vec_dot(contacts, mean);
    w->lost += h*dem_vec_dot(drag, mean);
}

void dem_wall_rotation_drift(struct dem_wall_body *b, double dt)
{
    const double back[4] = {b->rotation.principal[0], -b->rotation.principal[1], -b->rotation.principal[2],
                            -b->rotation.principal[3]};
    struct dem_clump as;

    as_clump(b, &as);
    dem_clump_turn(&as, dt);
    memcpy(b->state.rotation_before, b->state.rotation, sizeof b->state.rotation);
    dem_clump_product(as.q, back, b->state.rotation);
}

double dem_wall_rotation_kinetic(const struct dem_wall_body *b)
{
    double w[3];

    dem_wall_rotation_spin(b, w);
    return 0.5*dem_vec_dot(w, b->state.momentum);
}

void dem_wall_rotation_spin(const struct dem_wall_body *b, double w[3])
{
    struct dem_clump as;

    as_clump(b, &as);
    dem_clump_spin(&as, w);
}
