/*
 * scene_motion.c -- read the motion of a wall and the velocity of its surface.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/scene_internal.h"
#include "core/error.h"
#include "core/did_you_mean.h"
#include "core/memory.h"
#include <math.h>
#include <string.h>

/* Origin and unit axis of a rotation. */
static int read_axis(const struct dem_dict *dict, double origin[3], double axis[3])
{
    DEM_TRY(dem_dict_vector(dict, "origin", "m", origin));
    return dem_scene_read_direction(dict, axis);
}

static int read_omega(const struct dem_dict *dict, double *omega)
{
    DEM_TRY(dem_dict_number(dict, "omega", "rad/s", omega));
    DEM_REQUIRE(fabs(*omega) < DEM_MOTION_LIMIT, DEM_ERROR_INPUT,
                "%s: omega %g rad/s; give a number below %g", dem_dict_where(dict), *omega,
                DEM_MOTION_LIMIT);
    return DEM_OK;
}

static int read_oscillation(const struct dem_dict *dict, struct dem_motion *m)
{
    DEM_TRY(dem_dict_vector(dict, "amplitude", "m", m->amplitude));
    DEM_TRY(dem_dict_number(dict, "frequency", "1/s", &m->frequency));
    DEM_TRY(dem_dict_number_or(dict, "phase", "rad", 0.0, &m->phase));
    DEM_REQUIRE(m->frequency > 0.0 && m->frequency < DEM_MOTION_LIMIT, DEM_ERROR_INPUT,
                "%s: frequency %g 1/s; give a number above 0 and below %g", dem_dict_where(dict),
                m->frequency, DEM_MOTION_LIMIT);
    DEM_REQUIRE(fabs(m->phase) < DEM_MOTION_LIMIT, DEM_ERROR_INPUT,
                "%s: phase %g rad; give an angle from 0 to 6.28", dem_dict_where(dict), m->phase);
    return DEM_OK;
}

/* The axis is needed if the angle changes. */
static int read_table(const struct dem_dict *dict, struct dem_motion_part *p)
{
    static const char *const columns[] = {"x", "y", "z", "angle"};
    double rate[DEM_TIME_TABLE_COLUMNS];

    p->motion.kind = DEM_MOTION_TABLE;
    DEM_TRY(dem_scene_read_time_table(dict, columns, 4, &p->table));
    dem_time_table_rates(p->table, rate);
    return rate[3] > 0.0 || dem_dict_has(dict, "axis") || dem_dict_has(dict, "origin")
             ? read_axis(dict, p->motion.origin, p->motion.axis)
             : DEM_OK;
}

static int read_formula(const struct dem_dict *dict, const char *type, struct dem_motion *m)
{
    static const char *const known[] = {"translation", "rotation", "oscillation", "table",
                                        "free", "hinge", "servo"};

    if (strcmp(type, known[0]) == 0)
    {
        m->kind = DEM_MOTION_TRANSLATION;
        return dem_dict_vector(dict, "velocity", "m/s", m->velocity);
    }
    if (strcmp(type, known[1]) == 0)
    {
        m->kind = DEM_MOTION_ROTATION;
        DEM_TRY(read_axis(dict, m->origin, m->axis));
        return read_omega(dict, &m->omega);
    }
    if (strcmp(type, known[2]) == 0)
    {
        m->kind = DEM_MOTION_OSCILLATION;
        return read_oscillation(dict, m);
    }
    return dem_error_prefix(dem_did_you_mean_error("type of motion", type, known, 7),
                            "%s: ", dem_dict_where(dict));
}

struct motion_reader
{
    const struct dem_wall *wall;
    struct dem_compound_motion *motion;
};

/* Append one motion of a wall. */
static int read_motion(void *context, const struct dem_dict *dict)
{
    const struct motion_reader *const r = context;
    struct dem_compound_motion *const c = r->motion;
    const char *type;

    DEM_REQUIRE(c->parts < DEM_MOTION_PARTS, DEM_ERROR_INPUT,
                "%s: a wall has at most %d motions; join some of them in a table",
                dem_dict_where(dict), DEM_MOTION_PARTS);
    DEM_REQUIRE(!c->body, DEM_ERROR_INPUT, "%s: a motion by force is the last one of a wall; put it "
                "behind the others", dem_dict_where(dict));
    DEM_TRY(dem_dict_word(dict, "type", &type));
    DEM_TRY(dem_scene_read_body(dict, type, r->wall, &c->body));
    if (c->body)
    {
        return DEM_OK;
    }
    struct dem_motion_part *const p = &c->part[c->parts++];

    DEM_TRY(dem_scene_read_times(dict, &p->motion.start, &p->motion.end, p->motion.stage));
    return strcmp(type, "table") == 0 ? read_table(dict, p) : read_formula(dict, type, &p->motion);
}

/* A surface that turns like a solid (omega), or a belt around an axis (speed). */
static int read_surface_rotation(const struct dem_dict *dict, struct dem_wall *wall)
{
    const bool belt = dem_dict_has(dict, "speed");
    double omega;

    DEM_TRY(read_axis(dict, wall->drive.origin, wall->drive.axis));
    DEM_REQUIRE(belt != dem_dict_has(dict, "omega"), DEM_ERROR_INPUT,
                "%s: give omega [rad/s] for a surface that turns like a solid, or speed [m/s] for "
                "a belt around the axis, one of the two", dem_dict_where(dict));
    if (belt)
    {
        return dem_dict_number(dict, "speed", "m/s", &wall->drive.speed);
    }
    DEM_TRY(read_omega(dict, &omega));
    for (int k = 0; k < 3; k++)
    {
        wall->drive.spin[k] = wall->drive.axis[k]*omega;
    }
    return DEM_OK;
}

/* Velocity of the surface relative to the wall, as of a conveyor belt. */
static int read_surface_velocity(const struct dem_dict *dict, struct dem_wall *wall)
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    const struct dem_dict *turn;

    DEM_TRY(dem_dict_vector_or(dict, "surfaceVelocity", "m/s", zero, wall->drive.velocity));
    DEM_TRY(dem_dict_sub_if(dict, "surfaceRotation", &turn));
    wall->driven = turn || dem_dict_has(dict, "surfaceVelocity");
    return turn ? read_surface_rotation(turn, wall) : DEM_OK;
}

/* One formula is a motion of the wall's own; all else is a compound. */
static int use_motion(struct dem_walls *w, int wall, struct dem_compound_motion *c)
{
    if (c->parts != 1 || c->part[0].table || c->body)
    {
        return dem_walls_set_compound(w, wall, c);
    }
    const int status = dem_walls_set_motion(w, wall, &c->part[0].motion);

    dem_compound_motion_free(c);
    return status;
}

int dem_scene_read_motion(struct dem_walls *w, int wall, const struct dem_dict *dict)
{
    struct dem_compound_motion *c;

    DEM_TRY(read_surface_velocity(dict, &w->wall[wall]));
    DEM_TRY(DEM_NEW(c, 1));
    struct motion_reader r = {.wall = &w->wall[wall], .motion = c};
    const int status = dem_dict_each_item(dict, "motion", read_motion, &r);

    if (status || (c->parts == 0 && !c->body))
    {
        dem_compound_motion_free(c);
        return status;
    }
    return dem_error_prefix(use_motion(w, wall, c), "%s: %s/motion: ", dem_dict_where(dict),
                            dem_dict_path(dict));
}
