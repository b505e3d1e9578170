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

/* What a column of a table reaches, and 0: it does not leave its rows between them. */
static void table_range(const struct dem_time_table *t, int column, double range[2])
{
    range[0] = range[1] = 0.0;
    for (size_t k = 0; k < t->rows; k++)
    {
        add_to_extent(t->row[k].value[column], range);
    }
}

static void part_travel(const struct dem_motion_part *p, int axis, double range[2])
{
    if (p->table)
    {
        table_range(p->table, axis, range);
    }
    else
    {
        dem_motion_travel(&p->motion, axis, range);
    }
}

/* Displacements of the parts of a compound along an axis, added up; a rotation about that axis has none. */
static void compound_travel(const struct dem_compound_motion *c, int axis, double range[2])
{
    range[0] = range[1] = c->body ? INFINITY : 0.0;
    range[0] = -range[0];
    for (int k = 0; k < c->parts; k++)
    {
        double own[2];

        part_travel(&c->part[k], axis, own);
        range[0] += own[0];
        range[1] += own[1];
    }
}

/* Bounds of a box in a rotation from turn[0] to turn[1] [rad]. At each angle its corners are the outermost points. */
static void turn_box(const double centre[3], const double about[3], const double turn[2], double box[3][2])
{
    double from[3][2];
    int bounded = 1;

    memcpy(from, box, sizeof from);
    for (int k = 0; k < 3; k++)
    {
        bounded &= isfinite(box[k][0]) && isfinite(box[k][1]);
    }
    for (int k = 0; k < 3; k++)
    {
        box[k][0] = bounded ? box[k][0] : -INFINITY;
        box[k][1] = bounded ? box[k][1] : INFINITY;
        for (int corner = 0; bounded && corner < 8; corner++)
        {
            const double x[3] = {from[0][corner & 1], from[1][corner >> 1 & 1], from[2][corner >> 2]};

            add_turning(centre, about, turn[0], x, k, box[k]);
            add_turning(centre, about, turn[1], x, k, box[k]);
        }
    }
}

/* Bounds of a point in motions one after the other, of which some rotate. */
static void compound_box(const struct dem_compound_motion *c, double box[3][2])
{
    static const double round[2] = {0.0, whole};

    for (int k = 0; k < c->parts; k++)
    {
        const struct dem_motion *const m = &c->part[k].motion;
        double turn[2] = {0.0, m->kind == DEM_MOTION_ROTATION && m->omega != 0.0 ? m->omega*dem_motion_duration(m) : 0.0};

        if (c->part[k].table)
        {
            table_range(c->part[k].table, 3, turn);
        }
        if (turn[0] != 0.0 || turn[1] != 0.0)
        {
            turn_box(m->origin, m->axis, turn, box);
        }
        for (int a = 0; a < 3; a++)
        {
            double own[2];

            part_travel(&c->part[k], a, own);
            box[a][0] += own[0];
            box[a][1] += own[1];
        }
    }
    if (c->body)
    {
        turn_box(c->body->origin, c->body->axis[0], round, box);
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
    const struct dem_compound_motion *const c = f ? f->compound : NULL;
    int any;

    if (c && (c->body ? c->body->kind == DEM_WALL_BODY_HINGE : dem_compound_motion_leans(c, axis, &any) != NULL))
    {
        double box[3][2] = {{at[0], at[0]}, {at[1], at[1]}, {at[2], at[2]}};

        compound_box(c, box);
        memcpy(extent, box[axis], sizeof box[axis]);
        return;
    }
    if (c)
    {
        compound_travel(c, axis, range);
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
