/*
 * wall_images.c -- periodic images of walls of triangles, which need no storage.
 *
 * A wall at rest is periodic when its images are, and so is one that is displaced, as displacements
 * commute with a period; one that rotates only about a periodic axis. Another motion is refused where
 * the wall comes near a periodic face (dem_domain_check_walls).
 *
 * A particle at x meets image n of a triangle as it would meet the triangle at x - n L:
 *
 *   X = Q^T (x - s) - n L
 *
 *   Q, s   pose of the wall's reference frame (wall_motion.h), Q L = L                    [1, m]
 *   L      the period                                                                     [m]
 *   n      a whole number
 *
 * x and L are multiples of the domain's unit (domain.h), and s is rounded to one, so X is exact: a
 * contact has the same bits before and after the particle is wrapped. For this s is kept less than a
 * period long: dem_walls_wrap takes whole periods off whenever lists are made, and wall neighbors
 * count n from there. Poses of walls that never come near a periodic face are left as they are.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/vec.h"
#include "model/walls.h"
#include <math.h>
#include <string.h>

static int whole_number(double n)
{
    return (int)fmax(-DEM_WALL_IMAGES, fmin(DEM_WALL_IMAGES, n));
}

void dem_walls_image_range(double period, const double extent[2], const double other[2],
                           int range[2])
{
    range[0] = period > 0.0 ? whole_number(ceil((other[0] - extent[1])/period)) : 0;
    range[1] = period > 0.0 ? whole_number(floor((other[1] - extent[0])/period)) : 0;
}

/* ---- facets ---------------------------------------------------------------------------------- */

void dem_walls_place_corner(const struct dem_walls *w, const struct dem_triangle *t, int k,
                            double corner[3])
{
    const double *const period = dem_walls_period(w, w->wall[t->wall].frame);

    memcpy(corner, t->corner[k], sizeof t->corner[k]);
    for (int a = 0; a < 3 && t->place != DEM_SHIFT_NONE; a++)
    {
        corner[a] += dem_shift_axis(t->place, a)*period[a];
    }
}

/* An endless facet is parallel to the axis but for the tolerance of coplanar triangles. */
void dem_walls_set_plane(const struct dem_walls *w, struct dem_facet *r,
                         const struct dem_triangle *t, double size, const double area[3])
{
    double corner[3], normal[3];

    for (int k = 0; k < 3 && size > 0.0; k++)
    {
        r->normal[k] = area[k]/size;
    }
    for (int k = 0; k < 3 && r->endless; k++)
    {
        normal[k] = r->endless >> k & 1 ? 0.0 : r->normal[k];
    }
    for (int k = 0; k < 3 && r->endless; k++)
    {
        r->normal[k] = normal[k]/dem_vec_norm(normal);
    }
    dem_walls_place_corner(w, t, 0, corner);
    r->offset = dem_vec_dot(r->normal, corner);
}

/* ---- extent ---------------------------------------------------------------------------------- */

/* Displacements along an axis that a motion without rotation reaches [m]. */
static void travel(const struct dem_motion *m, int axis, double range[2])
{
    const double v = m->velocity[axis], a = fabs(m->amplitude[axis]),
                 end = v > 0.0 || v < 0.0 ? v*(m->end - m->start) : 0.0;
    const int swings = m->kind == DEM_MOTION_OSCILLATION;

    range[0] = swings ? -a : fmin(end, 0.0);
    range[1] = swings ? a : fmax(end, 0.0);
}

static void add_to_extent(double at, double extent[2])
{
    extent[0] = fmin(extent[0], at);
    extent[1] = fmax(extent[1], at);
}

/* A point on its way round: along an axis it is at  middle + A cos(angle) + B sin(angle). */
static void add_rotating(const struct dem_motion *m, const double x[3], int axis, double extent[2])
{
    const double turn = m->omega*(m->end - m->start), whole = 6.28318530717958648;
    double d[3], across[3];

    dem_vec_minus(x, m->origin, d);
    dem_vec_cross(m->axis, d, across);
    const double along = dem_vec_dot(d, m->axis)*m->axis[axis], a = d[axis] - along,
                 b = across[axis], middle = m->origin[axis] + along, radius = sqrt(a*a + b*b);

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

void dem_walls_swept_extent(const struct dem_walls *w, const struct dem_triangle *t, int axis,
                            double extent[2])
{
    const int frame = w->wall[t->wall].frame;
    const struct dem_motion *const m = frame < 0 ? NULL : &w->frame[frame].motion;
    double range[2] = {0.0, 0.0};

    extent[0] = INFINITY;
    extent[1] = -INFINITY;
    for (int k = 0; k < 3; k++)
    {
        if (m && m->kind == DEM_MOTION_ROTATION)
        {
            add_rotating(m, t->corner[k], axis, extent);
        }
        else
        {
            add_to_extent(t->corner[k][axis], extent);
        }
    }
    if (m && m->kind != DEM_MOTION_ROTATION)
    {
        travel(m, axis, range);
    }
    extent[0] += range[0];
    extent[1] += range[1];
}

/* ---- reference frames ------------------------------------------------------------------------ */

static int is_along(const double axis[3], int k)
{
    return axis[(k + 1)%3] == 0.0 && axis[(k + 2)%3] == 0.0;
}

/* 1 when the triangles of a frame come near a periodic face. */
static int comes_near(const struct dem_walls *w, const struct dem_wall_frame *f, int k)
{
    double range[2];

    travel(&f->motion, k, range);
    return f->triangles && (f->box[0][k] + range[0] < w->face[0][k] + w->reach ||
                            f->box[1][k] + range[1] > w->face[1][k] - w->reach);
}

void dem_walls_choose_periods(struct dem_walls *w)
{
    for (int m = 0; w->periodic && m < w->frames; m++)
    {
        struct dem_wall_frame *const f = &w->frame[m];

        for (int k = 0; k < 3; k++)
        {
            const int can = f->motion.kind != DEM_MOTION_ROTATION || is_along(f->motion.axis, k);

            f->period[k] = w->period[k] > 0.0 && can && comes_near(w, f, k) ? w->period[k] : 0.0;
        }
    }
}

/* The nearest whole number of periods in a displacement [m]; exact, however far it is. */
static double whole_periods(double s, double period)
{
    return rint((s - remainder(s, period))/period);
}

void dem_walls_make_pose_periodic(const struct dem_walls *w, struct dem_wall_frame *f)
{
    struct dem_pose *const p = &f->pose;

    for (int k = 0; k < 3; k++)
    {
        if (f->period[k] > 0.0 && f->motion.kind == DEM_MOTION_ROTATION)
        {
            for (int m = 0; m < 3; m++)
            {
                p->rotation[k][m] = p->rotation[m][k] = m == k ? 1.0 : 0.0;
            }
            p->shift[k] = 0.0;
        }
        else if (f->period[k] > 0.0)
        {
            const double s = w->unit[k]*rint(p->shift[k]/w->unit[k]);

            p->shift[k] = remainder(s, f->period[k]) +
                          (whole_periods(s, f->period[k]) - f->turns[k])*f->period[k];
        }
    }
}

void dem_walls_wrap(struct dem_walls *w)
{
    for (int m = 0; w->periodic && m < w->frames; m++)
    {
        struct dem_wall_frame *const f = &w->frame[m];

        for (int k = 0; k < 3; k++)
        {
            const double n = f->period[k] > 0.0 ? whole_periods(f->pose.shift[k], f->period[k]) : 0.0;

            f->turns[k] += n;
            f->pose.shift[k] -= n*f->period[k];
            for (size_t i = 0; n != 0.0 && i < w->marks; i++)
            {
                struct dem_mark *const mark = &w->mark[i];
                const double off = mark->frame == m ? n*f->period[k] : 0.0;

                mark->last[k] -= off;
                for (int r = 0; r < DEM_MARK_REFERENCES; r++)
                {
                    mark->reference[r][k] -= off;
                }
            }
        }
    }
}
