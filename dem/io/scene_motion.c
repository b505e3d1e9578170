/*
 * scene_motion.c -- the words about the motion of a wall and of its surface.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/scene_parts.h"
#include "base/error.h"
#include "base/unknown.h"
#include "base/vec.h"
#include <math.h>
#include <string.h>

/* 1/s and s: a double tells no angle apart beyond, and all angles stay finite. */
static const double most_rate = 1e15, most_time = 1e15;

/* An axis to turn about, and how fast. */
static int read_turn(const struct dem_dict *dict, double origin[3], double axis[3], double *omega)
{
    DEM_TRY(dem_dict_vector(dict, "origin", "m", origin));
    DEM_TRY(dem_dict_vector(dict, "axis", "1", axis));
    DEM_TRY(dem_dict_number(dict, "omega", "rad/s", omega));
    const double size = dem_vec_norm(axis);

    DEM_REQUIRE(fabs(*omega) < most_rate, DEM_ERROR_INPUT, "%s: omega %g rad/s; give a number below %g", dem_dict_where(dict), *omega,
                most_rate);
    DEM_REQUIRE(size > 0.0 && isfinite(size), DEM_ERROR_INPUT, "%s: axis (%g %g %g) has no direction; give a vector along it",
                dem_dict_where(dict), axis[0], axis[1], axis[2]);
    for (int k = 0; k < 3; k++)
    {
        axis[k] /= size;
    }
    return DEM_OK;
}

static int read_oscillation(const struct dem_dict *dict, struct dem_motion *m)
{
    DEM_TRY(dem_dict_vector(dict, "amplitude", "m", m->amplitude));
    DEM_TRY(dem_dict_number(dict, "frequency", "1/s", &m->frequency));
    DEM_TRY(dem_dict_number_or(dict, "phase", "rad", 0.0, &m->phase));
    DEM_REQUIRE(m->frequency > 0.0 && m->frequency < most_rate, DEM_ERROR_INPUT, "%s: frequency %g 1/s; give a number above 0 and below %g",
                dem_dict_where(dict), m->frequency, most_rate);
    DEM_REQUIRE(fabs(m->phase) < most_rate, DEM_ERROR_INPUT, "%s: phase %g rad; give a part of a turn, up to 6.28", dem_dict_where(dict),
                m->phase);
    return DEM_OK;
}

static int read_motion(const struct dem_dict *dict, struct dem_motion *m)
{
    static const char *const known[] = {"translation", "rotation", "oscillation"};
    const char *type;

    DEM_TRY(dem_dict_word(dict, "type", &type));
    DEM_TRY(dem_dict_number_or(dict, "start", "s", 0.0, &m->start));
    m->end = INFINITY;
    if (dem_dict_has(dict, "end"))
    {
        DEM_TRY(dem_dict_number(dict, "end", "s", &m->end));
    }
    DEM_REQUIRE(fabs(m->start) < most_time, DEM_ERROR_INPUT, "%s: start %g s; give a time within %g s of 0", dem_dict_where(dict), m->start,
                most_time);
    DEM_REQUIRE(m->end > m->start, DEM_ERROR_INPUT, "%s: end %g s is not after start %g s", dem_dict_where(dict), m->end, m->start);
    if (strcmp(type, known[0]) == 0)
    {
        m->kind = DEM_MOTION_TRANSLATION;
        return dem_dict_vector(dict, "velocity", "m/s", m->velocity);
    }
    if (strcmp(type, known[1]) == 0)
    {
        m->kind = DEM_MOTION_ROTATION;
        return read_turn(dict, m->origin, m->axis, &m->omega);
    }
    if (strcmp(type, known[2]) == 0)
    {
        m->kind = DEM_MOTION_OSCILLATION;
        return read_oscillation(dict, m);
    }
    return dem_error_prefix(dem_unknown_word("type of motion", type, known, 3), "%s: ", dem_dict_where(dict));
}

static int read_drive(const struct dem_dict *dict, struct dem_wall *wall)
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    const struct dem_dict *turn;
    double omega;

    DEM_TRY(dem_dict_vector_or(dict, "surfaceVelocity", "m/s", zero, wall->drive));
    DEM_TRY(dem_dict_sub_if(dict, "surfaceRotation", &turn));
    wall->driven = turn || dem_dict_has(dict, "surfaceVelocity");
    if (turn)
    {
        DEM_TRY(read_turn(turn, wall->drive_origin, wall->drive_spin, &omega));
        for (int k = 0; k < 3; k++)
        {
            wall->drive_spin[k] *= omega;
        }
    }
    return DEM_OK;
}

int dem_scene_read_motion(struct dem_walls *w, int wall, const struct dem_dict *dict)
{
    struct dem_motion motion;
    const struct dem_dict *sub;

    DEM_TRY(read_drive(dict, &w->wall[wall]));
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
