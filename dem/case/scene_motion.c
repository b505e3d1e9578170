/*
 * scene_motion.c -- read the motion of a wall and the velocity of its surface.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/scene_internal.h"
#include "core/error.h"
#include "core/did_you_mean.h"
#include "core/vec.h"
#include <math.h>
#include <string.h>

/* Origin and unit axis of a rotation. */
static int read_axis(const struct dem_dict *dict, double origin[3], double axis[3])
{
    DEM_TRY(dem_dict_vector(dict, "origin", "m", origin));
    DEM_TRY(dem_dict_vector(dict, "axis", "1", axis));
    const double size = dem_vec_norm(axis);

    DEM_REQUIRE(size > 0.0 && isfinite(size), DEM_ERROR_INPUT,
                "%s: axis (%g %g %g) has no direction; give a vector along it",
                dem_dict_where(dict), axis[0], axis[1], axis[2]);
    for (int k = 0; k < 3; k++)
    {
        axis[k] /= size;
    }
    return DEM_OK;
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

static int read_motion(const struct dem_dict *dict, struct dem_motion *m)
{
    static const char *const known[] = {"translation", "rotation", "oscillation"};
    const char *type;
    int from, to;

    DEM_TRY(dem_dict_word(dict, "type", &type));
    DEM_TRY(dem_dict_time_or(dict, "start", 0.0, &m->start, &from));
    DEM_TRY(dem_dict_time_or(dict, "end", INFINITY, &m->end, &to));
    DEM_REQUIRE(from || fabs(m->start) < DEM_MOTION_LIMIT, DEM_ERROR_INPUT,
                "%s: start %g s; give a time within %g s of 0", dem_dict_where(dict), m->start,
                DEM_MOTION_LIMIT);
    DEM_REQUIRE(to ? from < to : from || m->end > m->start, DEM_ERROR_INPUT,
                "%s: the motion does not end after it has started; give a later end",
                dem_dict_where(dict));
    m->stage[0] = (int16_t)from;
    m->stage[1] = (int16_t)to;
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
    return dem_error_prefix(dem_did_you_mean_error("type of motion", type, known, 3),
                            "%s: ", dem_dict_where(dict));
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

int dem_scene_read_motion(struct dem_walls *w, int wall, const struct dem_dict *dict)
{
    struct dem_motion motion;
    const struct dem_dict *sub;

    DEM_TRY(read_surface_velocity(dict, &w->wall[wall]));
    DEM_TRY(dem_dict_sub_if(dict, "motion", &sub));
    if (!sub)
    {
        return DEM_OK;
    }
    memset(&motion, 0, sizeof motion);
    DEM_TRY(read_motion(sub, &motion));
    const int status = dem_walls_set_motion(w, wall, &motion);

    return status ? dem_error_prefix(status, "%s: ", dem_dict_where(sub)) : DEM_OK;
}
