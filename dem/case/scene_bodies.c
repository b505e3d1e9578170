/*
 * scene_bodies.c -- read the motion of a wall that is moved by force: free, hinge or servo.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/scene_internal.h"
#include "core/did_you_mean.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "walls/wall_motion.h"
#include "walls/wall_turn.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* For "%s: %s: ": the line, and walls/NAME/motion. */
#define PLACE(dict) dem_dict_where(dict), dem_dict_path(dict)

static int read_load_table(const struct dem_dict *dict, const char *name, const struct dem_wall_body *b,
                           struct dem_time_table **to)
{
    static const char *const vector[] = {"x", "y", "z"}, *const number[] = {"value"};
    const struct dem_dict *sub;

    DEM_TRY(dem_dict_sub(dict, name, &sub));
    return b->kind == DEM_WALL_BODY_FREE ? dem_scene_read_time_table(sub, vector, 3, to)
                                         : dem_scene_read_time_table(sub, number, 1, to);
}

/* A vector for a free wall, else a number; or a table. */
static int read_load(const struct dem_dict *dict, const char *name, const char *unit,
                     struct dem_wall_body *b)
{
    static const double zero[3] = {0.0, 0.0, 0.0};

    if (dem_dict_has_dict(dict, name))
    {
        return read_load_table(dict, name, b, &b->table);
    }
    return b->kind == DEM_WALL_BODY_FREE ? dem_dict_vector_or(dict, name, unit, zero, b->force)
           : b->kind == DEM_WALL_BODY_SERVO ? dem_dict_number(dict, name, unit, &b->force[0])
                                            : dem_dict_number_or(dict, name, unit, 0.0, &b->force[0]);
}

static int read_positive(const struct dem_dict *dict, const char *name, const char *unit, double *value)
{
    DEM_TRY(dem_dict_number(dict, name, unit, value));
    DEM_REQUIRE(*value > 0.0 && *value < DEM_MOTION_LIMIT, DEM_ERROR_INPUT,
                "%s: %s: %s %g %s; give a number above 0 and below %g", PLACE(dict), name, *value,
                unit, DEM_MOTION_LIMIT);
    return DEM_OK;
}

/* `least`: the value without the entry. */
static int read_damping(const struct dem_dict *dict, const char *unit, double least,
                        struct dem_wall_body *b)
{
    DEM_TRY(dem_dict_number_or(dict, "damping", unit, least, &b->damping));
    DEM_REQUIRE(b->damping >= 0.0 || !dem_dict_has(dict, "damping"), DEM_ERROR_INPUT,
                "%s: %s: damping %g %s; give a number above or equal to 0", PLACE(dict), b->damping,
                unit);
    return DEM_OK;
}

/* ---- free ------------------------------------------------------------------------------------ */

/* axes (x z), rotations (y): coordinate axes. */
static int read_axes(const struct dem_dict *dict, const char *name, double axis[3][3], int *axes)
{
    static const char *const known[] = {"x", "y", "z"};
    const char *const *word;
    size_t n;

    DEM_TRY(dem_dict_words(dict, name, &word, &n));
    DEM_REQUIRE(n >= 1 && n <= 3, DEM_ERROR_INPUT,
                "%s: %s: %s with %zu words; give one to three of x y z", PLACE(dict), name, n);
    for (size_t k = 0; k < n; k++)
    {
        int a = 0;

        while (a < 3 && strcmp(word[k], known[a]) != 0)
        {
            a++;
        }
        if (a == 3)
        {
            return dem_error_prefix(dem_did_you_mean_error("axis", word[k], known, 3), "%s: %s: %s: ",
                                    PLACE(dict), name);
        }
        for (size_t m = 0; m < k; m++)
        {
            DEM_REQUIRE(axis[m][a] == 0.0, DEM_ERROR_INPUT,
                        "%s: %s: %s has %s twice; give each once", PLACE(dict), name, word[k]);
        }
        axis[k][a] = 1.0;
    }
    *axes = (int)n;
    return DEM_OK;
}

/* ---- rotation of a free wall ----------------------------------------------------------------- */

/* inertia (xx yy zz) or (xx yy zz xy xz yz): elements of the tensor about the centre. */
static int read_inertia(const struct dem_dict *dict, struct dem_wall_turn *t)
{
    const double *number;
    size_t n;

    DEM_TRY(dem_dict_vector(dict, "centre", "m", t->centre));
    DEM_TRY(dem_dict_numbers(dict, "inertia", "kg m2", &number, &n));
    DEM_REQUIRE(n == 3 || n == 6, DEM_ERROR_INPUT,
                "%s: %s: inertia with %zu numbers; give three (xx yy zz) or six (xx yy zz xy xz yz)",
                PLACE(dict), n);
    for (int k = 0; k < 3; k++)
    {
        t->tensor[k][k] = number[k];
        for (int l = 0; l < k && n == 6; l++)
        {
            t->tensor[k][l] = t->tensor[l][k] = number[2 + k + l];
        }
    }
    struct dem_wall_turn whole = *t;    /* about one axis, too, it is the inertia of a body */

    whole.axes = 3;
    dem_wall_turn_prepare(&whole, &dem_pose_identity);
    dem_wall_turn_prepare(t, &dem_pose_identity);
    DEM_REQUIRE(!dem_wall_turn_impossible(&whole), DEM_ERROR_INPUT,
                "%s: %s: no body has the inertia about its centre with the principal moments (%g %g %g) kg m2; each "
                "is above 0 and at most the sum of the others", PLACE(dict), whole.inertia[0],
                whole.inertia[1], whole.inertia[2]);
    return DEM_OK;
}

/* From `density` all follows (setup_bodies.c). */
static int read_mass(const struct dem_dict *dict, struct dem_wall_body *b)
{
    if (!dem_dict_has(dict, "density"))
    {
        DEM_TRY(read_positive(dict, "mass", "kg", &b->mass));
        return b->turn.axes > 0 ? read_inertia(dict, &b->turn) : DEM_OK;
    }
    DEM_REQUIRE(!dem_dict_has(dict, "mass") && !dem_dict_has(dict, "inertia") && !dem_dict_has(dict, "centre"),
                DEM_ERROR_INPUT, "%s: %s: both density and mass, centre or inertia; density gives them all; keep "
                "one", PLACE(dict));
    return read_positive(dict, "density", "kg/m3", &b->turn.density);
}

/* "x y", or "(0.6 0 0.8)" for an axis that is no coordinate axis. */
static void print_axes(const double (*axis)[3], int axes, char *text, size_t size)
{
    size_t n = 0;

    text[0] = '\0';
    for (int k = 0; k < axes && n < size; k++)
    {
        const char *const before = k > 0 ? " " : "";
        int a = 0;

        while (a < 3 && axis[k][a] != 1.0)
        {
            a++;
        }
        n += (size_t)(a < 3 ? snprintf(text + n, size - n, "%s%c", before, "xyz"[a])
                            : snprintf(text + n, size - n, "%s(%g %g %g)", before, axis[k][0], axis[k][1], axis[k][2]));
    }
}

/* The velocity or spin `v` that a free wall begins with has no part across its free axes. */
static int check_start(const struct dem_dict *dict, const struct dem_wall *of, const char *name, const char *unit,
                       const double v[3], const double (*axis)[3], int axes)
{
    static const double rounded = 1e-3;    /* of a direction printed with three decimals: at most sqrt(3)*5e-4 */
    const int spins = strcmp(name, "spin") == 0;
    double along[3] = {0.0, 0.0, 0.0}, across[3];
    char text[128];

    for (int k = 0; k < axes; k++)
    {
        const double part = dem_vec_dot(v, axis[k]);

        for (int l = 0; l < 3; l++)
        {
            along[l] += part*axis[k][l];
        }
    }
    dem_vec_minus(v, along, across);
    print_axes(axis, axes, text, sizeof text);
    DEM_REQUIRE(!(dem_vec_norm(across) > rounded*dem_vec_norm(v)), DEM_ERROR_INPUT,
                "%s: %s: %s (%g %g %g) %s, but wall %s %s %s only; give %s (%g %g %g), or more %s", PLACE(dict), name,
                v[0], v[1], v[2], unit, of->name, spins ? "rotates freely about" : "moves freely along", text, name,
                along[0], along[1], along[2], spins ? "rotations" : "axes");
    return DEM_OK;
}

static int read_turn(const struct dem_dict *dict, const struct dem_wall *of, struct dem_wall_body *b)
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    struct dem_wall_turn *const t = &b->turn;
    double axis[3][3] = {{0.0}};

    if (!dem_dict_has(dict, "rotations"))
    {
        return DEM_OK;
    }
    DEM_TRY(read_axes(dict, "rotations", axis, &t->axes));
    DEM_REQUIRE(t->axes != 2, DEM_ERROR_INPUT, "%s: %s: rotations about two axes, which would not stay fixed in "
                "space; give one or three", PLACE(dict));
    memcpy(t->axis, axis[0], sizeof t->axis);
    DEM_TRY(dem_dict_vector_or(dict, "spin", "1/s", zero, t->spin));
    DEM_TRY(check_start(dict, of, "spin", "1/s", t->spin, (const double (*)[3])axis, t->axes));
    DEM_TRY(dem_dict_number_or(dict, "angularDamping", "N m s/rad", 0.0, &t->damping));
    DEM_REQUIRE(t->damping >= 0.0, DEM_ERROR_INPUT, "%s: %s: angularDamping %g N m s/rad; give a number above or equal "
                "to 0", PLACE(dict), t->damping);
    return dem_dict_has_dict(dict, "torque") ? read_load_table(dict, "torque", b, &t->table)
                                             : dem_dict_vector_or(dict, "torque", "N m", zero, t->torque);
}

/* Velocity and spin at the start of the run. */
static int read_velocity(const struct dem_dict *dict, const struct dem_wall *of, struct dem_wall_body *b)
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    double v[3];

    DEM_TRY(dem_dict_vector_or(dict, "velocity", "m/s", zero, v));
    DEM_TRY(check_start(dict, of, "velocity", "m/s", v, (const double (*)[3])b->axis, b->axes));
    for (int k = 0; k < b->axes; k++)
    {
        b->state.v[k] = dem_vec_dot(v, b->axis[k]);
    }
    DEM_REQUIRE(!(dem_dict_has(dict, "velocity") || dem_dict_has(dict, "spin"))
                    || !(dem_dict_has(dict, "start") || of->there[0] > -INFINITY || of->there_stage[0]),
                DEM_ERROR_INPUT, "%s: %s: velocity and spin hold at the start of the run, but wall %s moves later; "
                "take them out, or start and from", PLACE(dict), of->name);
    return DEM_OK;
}

static int read_free_axes(const struct dem_dict *dict, const struct dem_wall *of, struct dem_wall_body *b)
{
    if (dem_dict_has(dict, "axes"))
    {
        return read_axes(dict, "axes", b->axis, &b->axes);
    }
    if (dem_dict_has(dict, "axis") || of->shape == DEM_SHAPE_PLANE)
    {
        b->axes = 1;
        memcpy(b->axis[0], of->normal, sizeof b->axis[0]);
        return dem_dict_has(dict, "axis") ? dem_scene_read_direction(dict, b->axis[0]) : DEM_OK;
    }
    b->axes = 3;
    for (int k = 0; k < 3; k++)
    {
        b->axis[k][k] = 1.0;
    }
    return DEM_OK;
}

/* *no: 1 when the wall has no weight. */
static int read_weight(const struct dem_dict *dict, struct dem_wall_body *b, int *no)
{
    bool weight;

    DEM_TRY(dem_dict_switch_or(dict, "weight", true, &weight));
    b->weight_given = dem_dict_has(dict, "weight");
    *no = !weight;
    return DEM_OK;
}

static int read_free(const struct dem_dict *dict, const struct dem_wall *of, struct dem_wall_body *b)
{
    int weightless;

    b->kind = DEM_WALL_BODY_FREE;
    DEM_TRY(read_turn(dict, of, b));
    DEM_TRY(read_mass(dict, b));
    DEM_TRY(read_damping(dict, "kg/s", 0.0, b));
    DEM_TRY(read_weight(dict, b, &weightless));
    b->weighs = weightless ? 0.0 : b->turn.density > 0.0 ? 1.0 : b->mass;    /* 1: times the mass to come */
    DEM_TRY(read_load(dict, "force", "N", b));
    DEM_TRY(read_free_axes(dict, of, b));
    return read_velocity(dict, of, b);
}

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
    int weightless;

    b->kind = DEM_WALL_BODY_HINGE;
    b->axes = 1;
    DEM_TRY(dem_dict_vector(dict, "origin", "m", b->origin));
    DEM_TRY(dem_scene_read_direction(dict, b->axis[0]));
    DEM_TRY(read_positive(dict, "inertia", "kg m2", &b->mass));
    DEM_TRY(read_damping(dict, "N m s/rad", 0.0, b));
    DEM_TRY(read_load(dict, "torque", "N m", b));
    DEM_TRY(read_stops(dict, b));
    if (dem_dict_has(dict, "mass"))
    {
        DEM_TRY(read_positive(dict, "mass", "kg", &b->weighs));
        DEM_TRY(dem_dict_vector(dict, "centre", "m", b->centre));
        DEM_TRY(check_inertia(dict, b));
        DEM_TRY(read_weight(dict, b, &weightless));
        b->weighs = weightless ? 0.0 : b->weighs;
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
    DEM_TRY(read_positive(dict, "maxSpeed", "m/s", &b->max_speed));
    DEM_TRY(read_damping(dict, "kg/s", -1.0, b));
    if (pressure)
    {
        DEM_TRY(read_positive(dict, "area", "m2", &b->area));
    }
    DEM_TRY(read_load(dict, pressure ? "pressure" : "force", pressure ? "Pa" : "N", b));
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
    b->area = b->state.turn[0] = b->state.turn_before[0] = 1.0;
    DEM_TRY(dem_scene_read_times(dict, &b->start, &b->end, b->stage));
    DEM_REQUIRE(of->shape == DEM_SHAPE_PLANE || of->shape == DEM_SHAPE_TRIANGLES, DEM_ERROR_INPUT,
                "%s: %s: wall %s is round; only planes and triangles are moved by force",
                PLACE(dict), of->name);
    return strcmp(type, "free") == 0    ? read_free(dict, of, b)
           : strcmp(type, "hinge") == 0 ? read_hinge(dict, b)
                                        : read_servo(dict, of, b);
}
