/*
 * wall_extent.c -- where points of walls come to in translations, oscillations, rotations and tables (wall_extent.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/wall_extent.h"
#include "core/vec.h"
#include <math.h>
#include <string.h>

void dem_motion_travel(const struct dem_motion *m, int axis, double range[2])
{
    const double v = m->velocity[axis], a = fabs(m->amplitude[axis]),
                 end = v > 0.0 || v < 0.0 ? v*dem_motion_duration(m) : 0.0;
    const int swings = m->kind == DEM_MOTION_OSCILLATION;

    range[0] = swings ? -a : fmin(end, 0.0);
    range[1] = swings ? a : fmax(end, 0.0);
}

static void add_to_extent(double at, double extent[2])
{
    extent[0] = fmin(extent[0], at);
    extent[1] = fmax(extent[1], at);
}

static const double whole = 6.28318530717958648;    /* turn */

/* A point on its way round a centre, by an angle: along an axis it is at  middle + A cos(angle) + B sin(angle). */
static void add_turning(const double centre[3], const double about[3], double turn, const double x[3], int axis,
                        double extent[2])
{
    double d[3], across[3];

    dem_vec_minus(x, centre, d);
    dem_vec_cross(about, d, across);
    const double along = dem_vec_dot(d, about)*about[axis], a = d[axis] - along, b = across[axis],
                 middle = centre[axis] + along, radius = sqrt(a*a + b*b);

    add_to_extent(x[axis], extent);
    if (fabs(turn) < whole)
    {
        add_to_extent(middle + a*cos(turn) + b*sin(turn), extent);
    }
    for (int side = 1; side >= -1; side -= 2)
    {
        /* the angle of the largest or smallest coordinate, in the direction of the rotation */
        double angle = atan2(side*b, side*a)*(turn < 0.0 ? -1.0 : 1.0);

        angle += angle < 0.0 ? whole : 0.0;
        if (angle <= fabs(turn))
        {
            add_to_extent(middle + side*radius, extent);
        }
    }
}

/* Displacements in a table, which does not leave its rows between them. */
static void table_travel(const struct dem_time_table *t, int axis, double range[2])
{
    range[0] = range[1] = 0.0;
    for (size_t k = 0; k < t->rows; k++)
    {
        add_to_extent(t->row[k].value[axis], range);
    }
}

/* Displacements of the parts of a compound along an axis, added up; a rotation about that axis has none. */
static void compound_travel(const struct dem_compound_motion *c, int axis, double range[2])
{
    int any;

    range[0] = range[1] = 0.0;
    if (c->body || dem_compound_motion_leans(c, axis, &any))
    {
        range[0] = -INFINITY;
        range[1] = INFINITY;
        return;
    }
    for (int k = 0; k < c->parts; k++)
    {
        double own[2];

        if (c->part[k].table)
        {
            table_travel(c->part[k].table, axis, own);
        }
        else
        {
            dem_motion_travel(&c->part[k].motion, axis, own);
        }
        range[0] += own[0];
        range[1] += own[1];
    }
}

void dem_walls_swept_point(const struct dem_walls *w, int frame, const double x[3], int axis, double extent[2])
{
    const struct dem_wall_frame *const f = frame < 0 ? NULL : &w->frame[frame];
    double at[3] = {x[0], x[1], x[2]}, range[2] = {0.0, 0.0};

    extent[0] = INFINITY;
    extent[1] = -INFINITY;
    if (f && f->resumed)
    {
        dem_pose_point(&f->base, x, at);
    }
    if (f && f->motion.kind == DEM_MOTION_ROTATION)
    {
        const struct dem_motion *const m = &f->motion;

        add_turning(m->origin, m->axis, m->omega != 0.0 ? m->omega*dem_motion_duration(m) : 0.0, at, axis, extent);
        return;
    }
    const struct dem_wall_body *const b = f && f->compound ? f->compound->body : NULL;

    if (b && b->kind == DEM_WALL_BODY_HINGE && f->compound->parts == 0)
    {
        add_turning(b->origin, b->axis[0], whole, at, axis, extent);
        return;
    }
    if (f && f->compound)
    {
        compound_travel(f->compound, axis, range);
    }
    else if (f)
    {
        dem_motion_travel(&f->motion, axis, range);
    }
    extent[0] = at[axis] + range[0];
    extent[1] = at[axis] + range[1];
}

void dem_walls_swept_extent(const struct dem_walls *w, const struct dem_triangle *t, int axis,
                            double extent[2])
{
    extent[0] = INFINITY;
    extent[1] = -INFINITY;
    for (int k = 0; k < 3; k++)
    {
        double own[2];

        dem_walls_swept_point(w, w->wall[t->wall].frame, t->corner[k], axis, own);
        add_to_extent(own[0], extent);
        add_to_extent(own[1], extent);
    }
}
