/*
 * wall_frames.c -- walls in motion: where each stands now, and how far it has come since lists were made.
 *
 * The displacement of a rigid body is an affine function of the point, and its length a convex one: over a wall of
 * triangles it is largest at a corner of the box around them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/error.h"
#include "base/memory.h"
#include "base/vec.h"
#include "state/walls.h"
#include <math.h>
#include <string.h>

/* Sine of the angle by which axes that should be parallel may differ. */
static const double parallel = 1e-9;

static int shape_follows(const struct dem_wall *w, const struct dem_motion *m)
{
    static const char *const says[] = {"", "plane (a box is made of them) turns about its normal only; build it from triangles",
                                       "cylinder turns about an axis along its own only; build it from triangles", ""};
    double across[3];

    if (m->kind == DEM_MOTION_ROTATION && (w->shape == DEM_SHAPE_PLANE || w->shape == DEM_SHAPE_CYLINDER))
    {
        dem_vec_cross(w->normal, m->axis, across);
        DEM_REQUIRE(dem_vec_norm(across) < parallel, DEM_ERROR_INPUT,
                    "wall %s: its rotation about (%g %g %g) would tilt it, and an infinite %s", w->name, m->axis[0], m->axis[1],
                    m->axis[2], says[w->shape]);
    }
    return DEM_OK;
}

static int same_motion(const struct dem_motion *a, const struct dem_motion *b)
{
    return a->kind == b->kind && a->start <= b->start && a->start >= b->start && a->end <= b->end && a->end >= b->end
        && memcmp(a->velocity, b->velocity, sizeof a->velocity) == 0 && memcmp(a->amplitude, b->amplitude, sizeof a->amplitude) == 0
        && memcmp(&a->frequency, &b->frequency, sizeof a->frequency) == 0 && memcmp(&a->phase, &b->phase, sizeof a->phase) == 0
        && memcmp(a->origin, b->origin, sizeof a->origin) == 0 && memcmp(a->axis, b->axis, sizeof a->axis) == 0
        && memcmp(&a->omega, &b->omega, sizeof a->omega) == 0;
}

int dem_walls_set_motion(struct dem_walls *w, int wall, const struct dem_motion *m)
{
    struct dem_wall *const of = &w->wall[wall];
    int k = 0;

    DEM_TRY(shape_follows(of, m));
    while (k < w->movings && !same_motion(&w->moving[k].motion, m))
    {
        k++;
    }
    if (k == w->movings)
    {
        DEM_TRY(DEM_GROW(w->moving, w->moving_room, w->movings + 1));
        w->moving[w->movings++] = (struct dem_moving){.motion = *m};
        dem_motion_pose(m, 0.0, &w->moving[k].pose);
    }
    of->moving = k;
    w->moving[k].triangles |= of->shape == DEM_SHAPE_TRIANGLES;
    return DEM_OK;
}

const double *dem_walls_own(const struct dem_walls *w, int wall, const double x[3], double room[3])
{
    const int moving = w->wall[wall].moving;

    if (moving < 0)
    {
        return x;
    }
    dem_pose_own(&w->moving[moving].pose, x, room);
    return room;
}

/* ---- marks --------------------------------------------------------------------------------------------------- */

static int add_mark(struct dem_walls *w, struct dem_mark mark)
{
    DEM_TRY(DEM_GROW(w->mark, w->mark_room, w->marks + 1));
    w->mark[w->marks++] = mark;
    return DEM_OK;
}

static int mark_box(struct dem_walls *w, int moving)
{
    double box[2][3] = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

    for (size_t k = 0; k < 3*w->triangles; k++)
    {
        const struct dem_triangle *const t = &w->triangle[k/3];

        for (int a = 0; a < 3 && w->wall[t->wall].moving == moving; a++)
        {
            box[0][a] = fmin(box[0][a], t->corner[k%3][a]);
            box[1][a] = fmax(box[1][a], t->corner[k%3][a]);
        }
    }
    for (int k = 0; k < 8; k++)
    {
        DEM_TRY(add_mark(w, (struct dem_mark){.moving = moving, .at = {box[k & 1][0], box[k >> 1 & 1][1], box[k >> 2][2]}}));
    }
    return DEM_OK;
}

int dem_walls_make_marks(struct dem_walls *w)
{
    static const enum dem_mark_counts counts[] = {DEM_MARK_ALL, DEM_MARK_ALONG, DEM_MARK_ACROSS, DEM_MARK_ALL};

    for (int k = 0; k < w->walls; k++)
    {
        const struct dem_wall *const of = &w->wall[k];
        struct dem_mark mark = {.moving = of->moving, .counts = counts[of->shape]};

        memcpy(mark.at, of->point, sizeof mark.at);
        memcpy(mark.normal, of->normal, sizeof mark.normal);
        if (of->moving >= 0 && of->shape != DEM_SHAPE_TRIANGLES)
        {
            DEM_TRY(add_mark(w, mark));
        }
    }
    for (int k = 0; k < w->movings; k++)
    {
        if (w->moving[k].triangles)
        {
            DEM_TRY(mark_box(w, k));
        }
    }
    return DEM_OK;
}

/* The normal and the axis do not turn where a mark has one: see shape_follows. */
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

static void place_mark(const struct dem_walls *w, const struct dem_mark *m, double at[3])
{
    dem_pose_point(&w->moving[m->moving].pose, m->at, at);
}

void dem_walls_move(struct dem_walls *w, double time, double dt)
{
    w->stride = 0.0;
    for (int k = 0; k < w->movings; k++)
    {
        dem_motion_pose(&w->moving[k].motion, time, &w->moving[k].pose);
        dem_motion_stride(&w->moving[k].motion, time, dt, &w->moving[k].stride);
    }
    for (size_t k = 0; k < w->marks; k++)
    {
        double now[3];

        place_mark(w, &w->mark[k], now);
        w->stride = dt > 0.0 ? fmax(w->stride, displacement(&w->mark[k], w->mark[k].last, now)) : 0.0;
        memcpy(w->mark[k].last, now, sizeof now);
    }
}

void dem_walls_remark(struct dem_walls *w, enum dem_list list)
{
    for (size_t k = 0; k < w->marks; k++)
    {
        place_mark(w, &w->mark[k], w->mark[k].then[list]);
    }
    w->since[list] = 0.0;
}

/* Of a wall at rest, or that follows a mesh. */
static double passes(const struct dem_wall *w, const double drift[3])
{
    const double along = dem_vec_dot(drift, w->normal);

    return w->shape == DEM_SHAPE_PLANE ? fabs(along)
         : w->shape == DEM_SHAPE_CYLINDER ? sqrt(fmax(0.0, dem_vec_dot(drift, drift) - along*along)) : dem_vec_norm(drift);
}

double dem_walls_moved(const struct dem_walls *w, enum dem_list list, const double drift[3])
{
    double most = 0.0, now[3];

    for (int k = 0; k < w->walls && dem_vec_dot(drift, drift) > 0.0; k++)
    {
        most = w->wall[k].moving < 0 ? fmax(most, passes(&w->wall[k], drift)) : most;
    }
    most += w->since[list];
    for (size_t k = 0; k < w->marks; k++)
    {
        place_mark(w, &w->mark[k], now);
        dem_vec_minus(now, drift, now);
        most = fmax(most, displacement(&w->mark[k], w->mark[k].then[list], now));
    }
    return most;
}
