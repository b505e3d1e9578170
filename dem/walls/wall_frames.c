/*
 * wall_frames.c -- reference frames of moving walls: present poses, and displacement since the
 * neighbor lists were built.
 *
 * The displacement field of a rigid body is an affine function of the point and its norm is convex.
 * Over a triangulated wall it is therefore largest at a corner of the bounding box, so only the
 * eight corners ("marks") are followed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "walls/walls.h"
#include <math.h>
#include <string.h>

void dem_wall_frame_pose(const struct dem_wall_frame *f, double time, struct dem_pose *pose)
{
    struct dem_pose motion;
    struct dem_pose *const to = f->resumed ? &motion : pose;

    if (f->compound)
    {
        dem_compound_motion_pose(f->compound, time, to);
    }
    else
    {
        dem_motion_pose(&f->motion, time, to);
    }
    if (f->resumed)
    {
        dem_pose_product(&motion, &f->base, pose);
    }
}

const double *dem_walls_to_frame(const struct dem_walls *w, int wall, const double x[3],
                                 double own[3])
{
    const int frame = w->wall[wall].frame;

    if (frame < 0)
    {
        return x;
    }
    dem_pose_to_frame(&w->frame[frame].pose, x, own);
    return own;
}

/* ---- speed along the normal ------------------------------------------------------------------ */

/* At the point x of the wall's frame, where the normal of a flat wall is n. */
static void add_push(const struct dem_walls *w, struct dem_wall *of, const double x[3],
                     const double n[3])
{
    double v[3], at[3], normal[3];

    if (of->frame < 0)
    {
        return;
    }
    dem_pose_point(&w->frame[of->frame].base, x, at);
    dem_pose_direction(&w->frame[of->frame].base, n, normal);
    if (w->frame[of->frame].compound)
    {
        dem_compound_motion_velocity(w->frame[of->frame].compound, at, v);
    }
    else
    {
        dem_motion_velocity(&w->frame[of->frame].motion, at, v);
    }
    const double along = dem_vec_dot(v, normal), square = dem_vec_dot(v, v);

    of->push = fmax(of->push, of->shape == DEM_SHAPE_SPHERE ? sqrt(square)
                              : of->shape == DEM_SHAPE_CYLINDER
                                  ? sqrt(fmax(square - along*along, 0.0))
                                  : fabs(along));
}

void dem_walls_find_push(struct dem_walls *w)
{
    for (int k = 0; k < w->walls; k++)
    {
        w->wall[k].push = 0.0;
        if (w->wall[k].shape != DEM_SHAPE_TRIANGLES)
        {
            add_push(w, &w->wall[k], w->wall[k].point, w->wall[k].normal);
        }
    }
    for (size_t k = 0; k < 3*w->triangles; k++)
    {
        const struct dem_triangle *const t = &w->triangle[k/3];

        add_push(w, &w->wall[t->wall], t->corner[k%3], w->facet[t->facet].normal);
    }
}

/* ---- marks ----------------------------------------------------------------------------------- */

static int add_mark(struct dem_walls *w, struct dem_mark mark)
{
    DEM_TRY(DEM_GROW(w->mark, w->mark_capacity, w->marks + 1));
    w->mark[w->marks++] = mark;
    return DEM_OK;
}

static int mark_box(struct dem_walls *w, int frame)
{
    for (int k = 0; k < 8; k++)
    {
        const double (*const box)[3] = (const double (*)[3])w->frame[frame].box;

        DEM_TRY(add_mark(w, (struct dem_mark){
            .frame = frame,
            .at = {box[k & 1][0], box[k >> 1 & 1][1],
                   box[k >> 2][2]}}));
    }
    return DEM_OK;
}

int dem_walls_make_marks(struct dem_walls *w)
{
    static const enum dem_mark_counts counts[] = {DEM_MARK_ALL, DEM_MARK_ALONG, DEM_MARK_ACROSS,
                                                  DEM_MARK_ALL};

    w->marks = 0;
    for (int k = 0; k < w->walls; k++)
    {
        const struct dem_wall *const of = &w->wall[k];
        struct dem_mark mark = {.frame = of->frame, .counts = counts[of->shape]};

        memcpy(mark.at, of->point, sizeof mark.at);
        memcpy(mark.normal, of->normal, sizeof mark.normal);
        if (of->frame >= 0 && of->shape != DEM_SHAPE_TRIANGLES)
        {
            DEM_TRY(add_mark(w, mark));
        }
    }
    for (int k = 0; k < w->frames; k++)
    {
        if (w->frame[k].triangles)
        {
            DEM_TRY(mark_box(w, k));
        }
    }
    return DEM_OK;
}

/* The normal or axis of a mark does not rotate: see check_shape. */
static double displacement(const struct dem_mark *m, const double from[3], const double to[3])
{
    double d[3];

    dem_vec_minus(to, from, d);
    const double along = dem_vec_dot(d, m->normal);

    if (m->counts == DEM_MARK_ALONG)
    {
        return fabs(along);
    }
    for (int k = 0; k < 3 && m->counts == DEM_MARK_ACROSS; k++)
    {
        d[k] -= along*m->normal[k];
    }
    return dem_vec_norm(d);
}

static void mark_position(const struct dem_walls *w, const struct dem_mark *m, double at[3])
{
    dem_pose_point(&w->frame[m->frame].pose, m->at, at);
}

void dem_walls_move(struct dem_walls *w, double time, double dt)
{
    w->displacement = 0.0;
    for (int k = 0; k < w->frames; k++)
    {
        dem_wall_frame_pose(&w->frame[k], time, &w->frame[k].pose);
        dem_walls_make_pose_periodic(w, &w->frame[k]);
        if (w->frame[k].compound)
        {
            /* between steps the velocity of the last one stays */
            if (dt > 0.0)
            {
                dem_compound_motion_displacement(w->frame[k].compound, time, dt,
                                                 &w->frame[k].displacement);
            }
        }
        else
        {
            dem_motion_displacement(&w->frame[k].motion, time, dt, &w->frame[k].displacement);
        }
    }
    for (size_t k = 0; k < w->marks; k++)
    {
        double now[3];

        mark_position(w, &w->mark[k], now);
        w->displacement =
            dt > 0.0 ? fmax(w->displacement, displacement(&w->mark[k], w->mark[k].last, now)) : 0.0;
        memcpy(w->mark[k].last, now, sizeof now);
    }
}

void dem_walls_reset_marks(struct dem_walls *w, enum dem_list list)
{
    for (size_t k = 0; k < w->marks; k++)
    {
        mark_position(w, &w->mark[k], w->mark[k].reference[list]);
    }
    w->since[list] = 0.0;
}

/* Displacement of a wall at rest, or of one that follows a mesh, relative to `drift`. */
static double relative_displacement(const struct dem_wall *w, const double drift[3])
{
    const double along = dem_vec_dot(drift, w->normal);

    return w->shape == DEM_SHAPE_PLANE ? fabs(along)
           : w->shape == DEM_SHAPE_CYLINDER
               ? sqrt(fmax(0.0, dem_vec_dot(drift, drift) - along*along))
               : dem_vec_norm(drift);
}

double dem_walls_max_displacement(const struct dem_walls *w, enum dem_list list,
                                  const double drift[3])
{
    double largest = 0.0, now[3];

    for (int k = 0; k < w->walls && dem_vec_dot(drift, drift) > 0.0; k++)
    {
        largest = w->wall[k].frame < 0 ? fmax(largest, relative_displacement(&w->wall[k], drift))
                                       : largest;
    }
    largest += w->since[list];
    for (size_t k = 0; k < w->marks; k++)
    {
        mark_position(w, &w->mark[k], now);
        dem_vec_minus(now, drift, now);
        largest = fmax(largest, displacement(&w->mark[k], w->mark[k].reference[list], now));
    }
    return largest;
}
