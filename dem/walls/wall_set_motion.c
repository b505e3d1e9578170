/*
 * wall_set_motion.c -- give a wall its motion, check that its shape can follow, and let it go on from
 * where it stood at a restart.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "walls/wall_rotation.h"
#include "walls/walls.h"
#include <string.h>

/* Tolerance of parallel axes: sine of the angle between them. */
static const double max_sine = 1e-9;

static int check_rotation(const struct dem_wall *w, const double about[3])
{
    static const char *const remedy[] =
        {"", "plane (a box is made of them) turns about its normal only; build it from triangles",
         "cylinder turns about an axis parallel to its own only; build it from triangles", ""};
    double across[3];

    if (w->shape == DEM_SHAPE_PLANE || w->shape == DEM_SHAPE_CYLINDER)
    {
        dem_vec_cross(w->normal, about, across);
        DEM_REQUIRE(dem_vec_norm(across) < max_sine, DEM_ERROR_INPUT,
                    "wall %s: its rotation about (%g %g %g) would tilt it, and an infinite %s",
                    w->name, about[0], about[1], about[2], remedy[w->shape]);
    }
    return DEM_OK;
}

static int check_shape(const struct dem_wall *w, const struct dem_motion *m)
{
    return m->kind == DEM_MOTION_ROTATION ? check_rotation(w, m->axis) : DEM_OK;
}

static int check_body(const struct dem_wall *w, const struct dem_compound_motion *c)
{
    const struct dem_wall_body *const b = c->body;
    double across[3];

    DEM_REQUIRE(b->rotation.axes == 0 || w->shape == DEM_SHAPE_TRIANGLES, DEM_ERROR_INPUT,
                "wall %s is a plane, which has no centre about which it could rotate; give triangles", w->name);
    DEM_REQUIRE(b->rotation.axes == 0 || c->parts == 0, DEM_ERROR_INPUT,
                "wall %s rotates freely, so it has no motion before that; take the others out", w->name);

    if (b->kind == DEM_WALL_BODY_HINGE)
    {
        return check_rotation(w, b->axis[0]);
    }
    dem_vec_cross(w->normal, b->axis[0], across);
    DEM_REQUIRE(w->shape != DEM_SHAPE_PLANE || (b->axes == 1 && dem_vec_norm(across) < max_sine),
                DEM_ERROR_INPUT, "wall %s is a plane: free along its normal only; give triangles",
                w->name);
    return DEM_OK;
}

static int check_compound(const struct dem_wall *w, const struct dem_compound_motion *c)
{
    double rate[DEM_TIME_TABLE_COLUMNS];

    for (int k = 0; k < c->parts; k++)
    {
        const struct dem_motion_part *const p = &c->part[k];

        DEM_TRY(check_shape(w, &p->motion));
        if (p->table)
        {
            dem_time_table_rates(p->table, rate);
            DEM_TRY(rate[3] > 0.0 ? check_rotation(w, p->motion.axis) : DEM_OK);
        }
    }
    return c->body ? check_body(w, c) : DEM_OK;
}

static int same_motion(const struct dem_motion *a, const struct dem_motion *b)
{
    return a->kind == b->kind && memcmp(a->stage, b->stage, sizeof a->stage) == 0 &&
           a->start <= b->start && a->start >= b->start && a->end <= b->end &&
           a->end >= b->end && memcmp(a->velocity, b->velocity, sizeof a->velocity) == 0 &&
           memcmp(a->amplitude, b->amplitude, sizeof a->amplitude) == 0 &&
           memcmp(&a->frequency, &b->frequency, sizeof a->frequency) == 0 &&
           memcmp(&a->phase, &b->phase, sizeof a->phase) == 0 &&
           memcmp(a->origin, b->origin, sizeof a->origin) == 0 &&
           memcmp(a->axis, b->axis, sizeof a->axis) == 0 &&
           memcmp(&a->omega, &b->omega, sizeof a->omega) == 0;
}

static int same_pose(const struct dem_pose *a, const struct dem_pose *b)
{
    return memcmp(a, b, sizeof *a) == 0;
}

static int use_frame(struct dem_walls *w, int wall, const struct dem_motion *m,
                     const struct dem_pose *base)
{
    int k = 0;

    while (k < w->frames
           && !(same_motion(&w->frame[k].motion, m) && same_pose(&w->frame[k].base, base)))
    {
        k++;
    }
    if (k == w->frames)
    {
        DEM_TRY(DEM_GROW(w->frame, w->frame_capacity, w->frames + 1));
        w->frame[w->frames++] = (struct dem_wall_frame){
            .motion = *m, .base = *base, .resumed = !same_pose(base, &dem_pose_identity)};
        dem_wall_frame_pose(&w->frame[k], 0.0, &w->frame[k].pose);
    }
    w->wall[wall].frame = k;
    return DEM_OK;
}

int dem_walls_set_motion(struct dem_walls *w, int wall, const struct dem_motion *m)
{
    DEM_TRY(check_shape(&w->wall[wall], m));
    return use_frame(w, wall, m, &dem_pose_identity);
}

int dem_walls_set_compound(struct dem_walls *w, int wall, struct dem_compound_motion *c)
{
    int status = check_compound(&w->wall[wall], c);

    status = status ? status : DEM_GROW(w->frame, w->frame_capacity, w->frames + 1);
    if (status)
    {
        dem_compound_motion_free(c);
        return status;
    }
    struct dem_wall_frame *const f = &w->frame[w->frames];

    *f = (struct dem_wall_frame){.motion = {.kind = DEM_MOTION_COMPOUND},
                                 .compound = c,
                                 .base = dem_pose_identity};
    dem_wall_frame_pose(f, 0.0, &f->pose);
    w->bodies += c->body != NULL;
    w->wall[wall].frame = w->frames++;
    return DEM_OK;
}

struct dem_wall_body *dem_walls_body(const struct dem_walls *w, int wall)
{
    const int frame = w->wall[wall].frame;

    return frame >= 0 && w->frame[frame].compound ? w->frame[frame].compound->body : NULL;
}

/* The frame of a compound motion is of one wall, so its base may change in place. */
static int rebase(struct dem_walls *w, int wall, const struct dem_motion *now,
                  const struct dem_pose *base)
{
    const int frame = w->wall[wall].frame;

    if (frame < 0 || !w->frame[frame].compound)
    {
        return same_pose(base, &dem_pose_identity) ? DEM_OK : use_frame(w, wall, now, base);
    }
    if (w->frame[frame].compound->body)
    {
        dem_wall_rotation_prepare(&w->frame[frame].compound->body->rotation, base);
    }
    w->frame[frame].base = *base;
    w->frame[frame].resumed = !same_pose(base, &dem_pose_identity);
    dem_wall_frame_pose(&w->frame[frame], 0.0, &w->frame[frame].pose);
    return DEM_OK;
}

/* *body: 1 when a body goes on with its state; *rows: 1 when only the rows of tables differ. */
static int same_compound(const struct dem_compound_motion *now, const struct dem_wall_before *was,
                         int *body, int *rows)
{
    const struct dem_motion_hash hash = dem_compound_motion_hash(now);
    const int formulas = was->compound && hash.formulas == was->hash.formulas,
              tables = hash.tables == was->hash.tables, bodies = hash.body == was->hash.body;

    *body = was->compound && now->body && bodies;
    *rows = formulas && bodies && !tables;
    return formulas && tables && bodies;
}

/* Velocity and spin of the scene hold at the start of a run, not where the wall is now. */
static void begin_at_rest(struct dem_wall_body_state *s)
{
    memset(s->v, 0, sizeof s->v);
    memset(s->momentum, 0, sizeof s->momentum);
}

int dem_walls_resume_motion(struct dem_walls *w, int wall, const struct dem_wall_before *was,
                            double time, int *rows)
{
    static const struct dem_motion rest = {.kind = DEM_MOTION_REST};
    const int frame = w->wall[wall].frame;
    struct dem_wall_frame now = {.motion = rest};
    struct dem_wall_frame before = {.motion = was->motion,
                                    .base = was->base,
                                    .resumed = !same_pose(&was->base, &dem_pose_identity)};
    struct dem_pose stood = was->stood, motion, back, base = was->base;

    if (frame >= 0)
    {
        now = w->frame[frame];
        now.resumed = 0;
    }
    int body = 0;

    *rows = 0;
    const int same = now.compound ? same_compound(now.compound, was, &body, rows)
                                  : !was->compound && same_motion(&was->motion, &now.motion);

    if (body)
    {
        now.compound->body->state = was->body;
    }
    else if (now.compound && now.compound->body)
    {
        begin_at_rest(&now.compound->body->state);
    }
    if (!same)
    {
        if (!was->compound)
        {
            dem_wall_frame_pose(&before, time, &stood);
        }
        dem_wall_frame_pose(&now, time, &motion);
        dem_pose_inverse(&motion, &back);
        dem_pose_product(&back, &stood, &base);
    }
    return rebase(w, wall, &now.motion, &base);
}

int dem_walls_axis(const struct dem_walls *w, int wall, double origin[3], double axis[3])
{
    static const double z[3] = {0.0, 0.0, 1.0}, zero[3] = {0.0, 0.0, 0.0};
    const struct dem_wall *const of = &w->wall[wall];
    const struct dem_wall_frame *const f = of->frame < 0 ? NULL : &w->frame[of->frame];
    const struct dem_wall_body *const b = dem_walls_body(w, wall);
    const struct dem_motion *const turns = !f ? NULL
                                           : f->compound ? dem_compound_motion_turns(f->compound)
                                           : f->motion.kind == DEM_MOTION_ROTATION ? &f->motion : NULL;
    const int hinge = b && b->kind == DEM_WALL_BODY_HINGE,
              belt = !f && of->driven && dem_vec_norm(of->drive.axis) > 0.0;

    memcpy(origin, hinge   ? b->origin
                   : turns ? turns->origin
                   : belt  ? of->drive.origin
                           : zero, sizeof zero);
    memcpy(axis, hinge ? b->axis[0] : turns ? turns->axis : belt ? of->drive.axis : z, sizeof z);
    return hinge || turns || belt;
}
