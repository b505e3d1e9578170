/*
 * scene_bodies.c -- read the motion of a wall that is moved by force: hinges and servos.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/scene_body_entries.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "walls/wall_motion.h"
#include <math.h>
#include <string.h>

/* ---- hinge ----------------------------------------------------------------------------------- */

/* 1  of numbers that were printed with three digits */
static const double rounded = 0.01;

static int read_stops(const struct dem_dict *dict, struct dem_wall_body *b)
{
    const double *angle;
    size_t n;

    b->stops[0] = -INFINITY;
    b->stops[1] = INFINITY;
    if (!dem_dict_has(dict, "stops"))
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_numbers(dict, "stops", "rad", &angle, &n));
    DEM_REQUIRE(n == 2 && angle[0] <= 0.0 && angle[1] >= 0.0 && angle[0] < angle[1], DEM_ERROR_INPUT,
                "%s: %s: stops are two angles [rad], the first at most 0, where the wall begins, the second "
                "at least 0", PLACE(dict));
    memcpy(b->stops, angle, sizeof b->stops);
    return DEM_OK;
}

/* The inertia about an axis is that about the centre of mass plus mass times distance squared. */
static int check_inertia(const struct dem_dict *dict, const struct dem_wall_body *b)
{
    double arm[3], across[3];

    dem_vec_minus(b->centre, b->origin, arm);
    dem_vec_cross(arm, b->axis[0], across);
    const double least = b->weighs*dem_vec_dot(across, across);

    DEM_REQUIRE(b->mass >= least*(1.0 - rounded), DEM_ERROR_INPUT,
                "%s: %s: inertia %g kg m2 about the axis, but mass %g kg with its centre %g m from the axis has "
                "at least %g kg m2; give that or more, or correct origin, axis and centre", PLACE(dict),
                b->mass, b->weighs, dem_vec_norm(across), least);
    return DEM_OK;
}

static int read_hinge(const struct dem_dict *dict, struct dem_wall_body *b)
{
    int weighs;

    b->kind = DEM_WALL_BODY_HINGE;
    b->axes = 1;
    DEM_TRY(dem_dict_vector(dict, "origin", "m", b->origin));
    DEM_TRY(dem_scene_read_direction(dict, b->axis[0]));
    DEM_TRY(dem_scene_read_positive(dict, "inertia", "kg m2", &b->mass));
    DEM_TRY(dem_scene_read_damping(dict, "N m s/rad", 0.0, b));
    DEM_TRY(dem_scene_read_load(dict, "torque", "N m", b));
    DEM_TRY(read_stops(dict, b));
    if (dem_dict_has(dict, "mass"))
    {
        DEM_TRY(dem_scene_read_positive(dict, "mass", "kg", &b->weighs));
        DEM_TRY(dem_dict_vector(dict, "centre", "m", b->centre));
        DEM_TRY(check_inertia(dict, b));
        DEM_TRY(dem_scene_read_weight(dict, b, &weighs));
        b->weighs = weighs ? b->weighs : 0.0;
    }
    return DEM_OK;
}

/* ---- servo ----------------------------------------------------------------------------------- */

/* A servo presses along its axis; a table may begin and end with 0. */
static int check_target(const struct dem_dict *dict, const char *name, const char *unit,
                        const struct dem_wall_body *b)
{
    double most = b->table ? 0.0 : b->force[0];

    for (size_t k = 0; b->table && k < b->table->rows; k++)
    {
        most = fmax(most, b->table->row[k].value[0]);
        DEM_REQUIRE(b->table->row[k].value[0] >= 0.0, DEM_ERROR_INPUT,
                    "%s: %s: %s %g %s at time %g s of the table; a servo presses along its axis: give numbers "
                    "above 0, or turn the axis", PLACE(dict), name, b->table->row[k].value[0], unit,
                    b->table->row[k].time);
    }
    DEM_REQUIRE(most > 0.0, DEM_ERROR_INPUT, "%s: %s: %s %g %s; a servo presses along its axis: give a "
                "number above 0, or turn the axis", PLACE(dict), name, most, unit);
    return DEM_OK;
}

static int read_servo(const struct dem_dict *dict, const struct dem_wall *of, struct dem_wall_body *b)
{
    const bool pressure = dem_dict_has(dict, "pressure");

    b->kind = DEM_WALL_BODY_SERVO;
    b->axes = 1;
    DEM_REQUIRE(pressure != dem_dict_has(dict, "force"), DEM_ERROR_INPUT,
                "%s: %s: give force [N] or pressure [Pa] with area [m2], one of the two",
                PLACE(dict));
    DEM_TRY(dem_scene_read_positive(dict, "maxSpeed", "m/s", &b->max_speed));
    DEM_TRY(dem_scene_read_damping(dict, "kg/s", -1.0, b));
    if (pressure)
    {
        DEM_TRY(dem_scene_read_positive(dict, "area", "m2", &b->area));
    }
    DEM_TRY(dem_scene_read_load(dict, pressure ? "pressure" : "force", pressure ? "Pa" : "N", b));
    DEM_TRY(check_target(dict, pressure ? "pressure" : "force", pressure ? "Pa" : "N", b));
    if (of->shape == DEM_SHAPE_PLANE && !dem_dict_has(dict, "axis"))
    {
        memcpy(b->axis[0], of->normal, sizeof b->axis[0]);
        return DEM_OK;
    }
    return dem_scene_read_direction(dict, b->axis[0]);
}

int dem_scene_read_body(const struct dem_dict *dict, const char *type, const struct dem_wall *of,
                        struct dem_wall_body **made)
{
    struct dem_wall_body *b;

    *made = NULL;
    if (strcmp(type, "free") != 0 && strcmp(type, "hinge") != 0 && strcmp(type, "servo") != 0)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(b, 1));
    *made = b;
    b->area = b->state.rotation[0] = b->state.rotation_before[0] = 1.0;
    DEM_TRY(dem_scene_read_times(dict, &b->start, &b->end, b->stage));
    DEM_REQUIRE(of->shape == DEM_SHAPE_PLANE || of->shape == DEM_SHAPE_TRIANGLES, DEM_ERROR_INPUT,
                "%s: %s: wall %s is round; only planes and triangles are moved by force",
                PLACE(dict), of->name);
    return strcmp(type, "free") == 0    ? dem_scene_read_free(dict, of, b)
           : strcmp(type, "hinge") == 0 ? read_hinge(dict, b)
                                        : read_servo(dict, of, b);
}
