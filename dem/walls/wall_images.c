/*
 * wall_images.c -- periodic images of walls of triangles, which need no storage.
 *
 * A wall at rest has periodic images. It still has them when it is displaced, as displacements
 * commute with a period, or rotates about a periodic axis. Any other motion is refused where the
 * wall comes near a periodic face (dem_domain_check_walls).
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
 * contact has the same bits before and after the particle is wrapped. For this s is kept less than
 * a period long: dem_walls_wrap takes whole periods off whenever lists are made, and wall neighbors
 * count n from there. Poses of walls that never come near a periodic face are left as they are.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "walls/wall_extent.h"
#include <math.h>
#include <string.h>

void dem_walls_turns(const struct dem_walls *w, int wall, int turns[3])
{
    const int frame = w->wall[wall].frame;

    for (int k = 0; k < 3; k++)
    {
        turns[k] = frame < 0 ? 0 : (int)fmod(w->frame[frame].turns[k], DEM_IMAGE_MASK + 1);
    }
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

/* of a facet along one axis */
struct facet_extent
{
    double from, to;              /* m */
    double rim[3];                /* m: the lowest middle of an edge on the rim */
};

static void add_triangle(const struct dem_walls *w, const struct dem_triangle *t, int axis,
                         struct facet_extent *e)
{
    double corner[3][3];

    for (int k = 0; k < 3; k++)
    {
        dem_walls_place_corner(w, t, k, corner[k]);
        e->from = fmin(e->from, corner[k][axis]);
        e->to = fmax(e->to, corner[k][axis]);
    }
    for (int k = 0; k < 3; k++)
    {
        const double *const a = corner[k], *const b = corner[(k + 1)%3],
                     middle[3] = {0.5*(a[0] + b[0]), 0.5*(a[1] + b[1]), 0.5*(a[2] + b[2])};

        if ((t->rim >> k & 1) && middle[axis] < e->rim[axis])
        {
            memcpy(e->rim, middle, sizeof e->rim);
        }
    }
}

/* 1 when a triangle at its place has the point x, to the tolerance of coplanar triangles. */
static int has_point(const struct dem_walls *w, const struct dem_triangle *t, const double x[3])
{
    const struct dem_facet *const r = &w->facet[t->facet];
    double corner[3][3], edge[3], to[3], across[3], side[3];

    for (int k = 0; k < 3; k++)
    {
        dem_walls_place_corner(w, t, k, corner[k]);
    }
    for (int k = 0; k < 3; k++)
    {
        dem_vec_minus(corner[(k + 1)%3], corner[k], edge);
        dem_vec_minus(x, corner[k], to);
        dem_vec_cross(edge, to, across);
        side[k] = dem_vec_dot(across, r->normal)/dem_vec_norm(edge);
    }
    return fabs(dem_vec_dot(r->normal, x) - r->offset) <= w->flatness &&
           (fmin(side[0], fmin(side[1], side[2])) >= -w->flatness ||
            fmax(side[0], fmax(side[1], side[2])) <= w->flatness);
}

/* 1 when the image of a facet that it may continue in begins on this triangle. */
static int continues(const struct dem_walls *w, const struct dem_triangle *t, int axis,
                     const struct facet_extent *e)
{
    const double period = dem_walls_period(w, w->wall[t->wall].frame)[axis];
    double begin[3] = {e->rim[0], e->rim[1], e->rim[2]};

    begin[axis] += period;
    return period > 0.0 && e->to - e->from >= period - w->flatness && isfinite(begin[axis]) &&
           has_point(w, t, begin);
}

static void make_endless(struct dem_walls *w, int axis)
{
    for (size_t t = 0; t < w->triangles; t++)
    {
        struct dem_triangle *const here = &w->triangle[t];
        struct dem_facet *const r = &w->facet[here->facet];
        int place[3];

        for (int k = 0; k < 3; k++)
        {
            place[k] = k == axis && (r->endless >> k & 1) ? 0 : dem_shift_axis(here->place, k);
        }
        here->place = (uint8_t)dem_shift_code(place[0], place[1], place[2]);
    }
    for (int k = 0; k < w->facets; k++)
    {
        struct dem_facet *const r = &w->facet[k];

        if ((r->endless >> axis & 1) && r->normal[axis] != 0.0)
        {
            const struct dem_triangle *const t = &w->triangle[dem_walls_find(w, r->largest)];

            dem_walls_set_plane(w, r, t, 1.0, (const double[3]){r->normal[0], r->normal[1],
                                                                r->normal[2]});
        }
    }
}

/* A facet that extends beyond both faces, or that is cut in another way at either, shares no edge
   with its image; it is endless where the image begins on it. */
static void compare_along(struct dem_walls *w, int axis, struct facet_extent *extent)
{
    for (int k = 0; k < w->facets; k++)
    {
        extent[k] = (struct facet_extent){.from = INFINITY,
                                          .to = -INFINITY,
                                          .rim = {INFINITY, INFINITY, INFINITY}};
    }
    for (size_t t = 0; t < w->triangles; t++)
    {
        add_triangle(w, &w->triangle[t], axis, &extent[w->triangle[t].facet]);
    }
    for (size_t t = 0; t < w->triangles; t++)
    {
        const struct dem_triangle *const here = &w->triangle[t];

        w->facet[here->facet].endless |=
            (uint8_t)(continues(w, here, axis, &extent[here->facet]) << axis);
    }
    make_endless(w, axis);
    for (int k = 0; k < w->facets; k++)
    {
        struct dem_facet *const r = &w->facet[k];
        const double period = dem_walls_period(w, w->wall[r->wall].frame)[axis];

        r->distinct |= (uint8_t)((period > 0.0 && !(r->endless >> axis & 1) &&
                                  extent[k].to - extent[k].from > period - 2.0*w->reach) << axis);
    }
}

int dem_walls_compare_images(struct dem_walls *w)
{
    struct facet_extent *extent;

    DEM_TRY(DEM_NEW(extent, w->facets + 1));
    for (int axis = 0; axis < 3; axis++)
    {
        if (w->period[axis] > 0.0)
        {
            compare_along(w, axis, extent);
        }
    }
    dem_memory_free(extent);
    return DEM_OK;
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

    if (f->compound)
    {
        return f->triangles && isfinite(f->box[0][k]);
    }
    dem_motion_travel(&f->motion, k, range);
    range[0] += f->base.shift[k];
    range[1] += f->base.shift[k];
    return f->triangles && isfinite(f->box[0][k]) &&
           (f->box[0][k] + range[0] < w->face[0][k] + w->reach ||
            f->box[1][k] + range[1] > w->face[1][k] - w->reach);
}

/* 1: of a product of a few rotations about one axis */
static const double round_off = 1e-12;

void dem_walls_choose_periods(struct dem_walls *w)
{
    for (int m = 0; w->periodic && m < w->frames; m++)
    {
        struct dem_wall_frame *const f = &w->frame[m];

        for (int k = 0; k < 3; k++)
        {
            int rotates;
            const int can = (f->compound ? !dem_compound_motion_leans(f->compound, k, &rotates)
                             : f->motion.kind != DEM_MOTION_ROTATION
                                 || is_along(f->motion.axis, k))
                         && fabs(f->base.rotation[k][k] - 1.0) < round_off;

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
        if (f->period[k] > 0.0)
        {
            const int rotates = f->motion.kind == DEM_MOTION_ROTATION;

            for (int m = 0; m < 3 && (rotates || f->compound || f->resumed); m++)
            {
                p->rotation[k][m] = p->rotation[m][k] = m == k ? 1.0 : 0.0;
            }
            p->shift[k] = rotates ? f->base.shift[k] : p->shift[k];
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
