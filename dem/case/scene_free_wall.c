/*
 * scene_free_wall.c -- read the motion of a free wall: its axes, mass and inertia, rotations, loads, and the velocity
 * and spin at the start.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/scene_body_entries.h"
#include "core/did_you_mean.h"
#include "core/error.h"
#include "core/vec.h"
#include "walls/wall_rotation.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* axes (x z), rotations (y): coordinate axes. */
static int read_axes(const struct dem_dict *dict, const char *name, double (*axis)[3], int *axes)
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

/* ---- mass ------------------------------------------------------------------------------------ */

/* inertia (xx yy zz) or (xx yy zz xy xz yz): elements of the tensor about the centre. */
static int read_inertia(const struct dem_dict *dict, struct dem_wall_rotation *t)
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
    struct dem_wall_rotation whole = *t;    /* about one axis, too, it is the inertia of a body */

    whole.axes = 3;
    dem_wall_rotation_prepare(&whole, &dem_pose_identity);
    dem_wall_rotation_prepare(t, &dem_pose_identity);
    DEM_REQUIRE(!dem_wall_rotation_impossible(&whole), DEM_ERROR_INPUT,
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
        DEM_TRY(dem_scene_read_positive(dict, "mass", "kg", &b->mass));
        return b->rotation.axes > 0 ? read_inertia(dict, &b->rotation) : DEM_OK;
    }
    DEM_REQUIRE(!dem_dict_has(dict, "mass") && !dem_dict_has(dict, "inertia") && !dem_dict_has(dict, "centre"),
                DEM_ERROR_INPUT, "%s: %s: both density and mass, centre or inertia; density gives them all; keep "
                "one", PLACE(dict));
    return dem_scene_read_positive(dict, "density", "kg/m3", &b->rotation.density);
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

/* what a wall is free along, or about */
struct freedom
{
    const char *wall, *moves, *entry;    /* its name; how it moves; the entry that gives the axes */
    int axes;
    double axis[3][3];
};

/* The entry `name` has no part across the free axes, which nothing would act on; `when`: for a row of a table. */
static int check_along(const struct dem_dict *dict, const struct freedom *f, const char *name, const char *unit,
                       const double v[3], const char *when)
{
    static const double rounded = 1e-3;    /* of a direction printed with three decimals: at most sqrt(3)*5e-4 */
    double along[3] = {0.0, 0.0, 0.0}, across[3];
    char text[128];

    for (int k = 0; k < f->axes; k++)
    {
        const double part = dem_vec_dot(v, f->axis[k]);

        for (int l = 0; l < 3; l++)
        {
            along[l] += part*f->axis[k][l];
        }
    }
    dem_vec_minus(v, along, across);
    print_axes(f->axis, f->axes, text, sizeof text);
    DEM_REQUIRE(!(dem_vec_norm(across) > rounded*dem_vec_norm(v)), DEM_ERROR_INPUT,
                "%s: %s: %s (%g %g %g) %s%s, but wall %s %s %s only; give %s (%g %g %g), or more %s", PLACE(dict), name,
                v[0], v[1], v[2], unit, when, f->wall, f->moves, text, name, along[0], along[1], along[2], f->entry);
    return DEM_OK;
}

/* The same of a load: a vector, or the rows of a table. */
static int check_load(const struct dem_dict *dict, const struct freedom *f, const char *name, const char *unit,
                      const double v[3], const struct dem_time_table *table)
{
    char when[64];

    for (size_t k = 0; table && k < table->rows; k++)
    {
        snprintf(when, sizeof when, " at time %g s of the table", table->row[k].time);
        DEM_TRY(check_along(dict, f, name, unit, table->row[k].value, when));
    }
    return table ? DEM_OK : check_along(dict, f, name, unit, v, "");
}

static int read_rotation(const struct dem_dict *dict, const struct dem_wall *of, struct dem_wall_body *b)
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    struct dem_wall_rotation *const t = &b->rotation;
    struct freedom f = {.wall = of->name, .moves = "rotates freely about", .entry = "rotations"};

    if (!dem_dict_has(dict, "rotations"))
    {
        return DEM_OK;
    }
    DEM_TRY(read_axes(dict, "rotations", f.axis, &f.axes));
    t->axes = f.axes;
    DEM_REQUIRE(t->axes != 2, DEM_ERROR_INPUT, "%s: %s: rotations about two axes, which would not stay fixed in "
                "space; give one or three", PLACE(dict));
    memcpy(t->axis, f.axis[0], sizeof t->axis);
    DEM_TRY(dem_dict_vector_or(dict, "spin", "1/s", zero, t->spin));
    DEM_TRY(check_along(dict, &f, "spin", "1/s", t->spin, ""));
    DEM_TRY(dem_dict_number_or(dict, "angularDamping", "N m s/rad", 0.0, &t->damping));
    DEM_REQUIRE(t->damping >= 0.0, DEM_ERROR_INPUT, "%s: %s: angularDamping %g N m s/rad; give a number above or equal "
                "to 0", PLACE(dict), t->damping);
    DEM_TRY(dem_dict_has_dict(dict, "torque") ? dem_scene_read_load_table(dict, "torque", b, &t->table)
                                              : dem_dict_vector_or(dict, "torque", "N m", zero, t->torque));
    return check_load(dict, &f, "torque", "N m", t->torque, t->table);
}

/* Force; velocity at the start of the run. */
static int read_translation(const struct dem_dict *dict, const struct dem_wall *of, struct dem_wall_body *b)
{
    struct freedom f = {.wall = of->name, .moves = "moves freely along", .entry = "axes", .axes = b->axes};
    static const double zero[3] = {0.0, 0.0, 0.0};
    double v[3];

    memcpy(f.axis, b->axis, sizeof f.axis);
    DEM_TRY(dem_scene_read_load(dict, "force", "N", b));
    DEM_TRY(check_load(dict, &f, "force", "N", b->force, b->table));
    DEM_TRY(dem_dict_vector_or(dict, "velocity", "m/s", zero, v));
    DEM_TRY(check_along(dict, &f, "velocity", "m/s", v, ""));
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

int dem_scene_read_free(const struct dem_dict *dict, const struct dem_wall *of, struct dem_wall_body *b)
{
    int weighs;

    b->kind = DEM_WALL_BODY_FREE;
    DEM_TRY(read_rotation(dict, of, b));
    DEM_TRY(read_mass(dict, b));
    DEM_TRY(dem_scene_read_damping(dict, "kg/s", 0.0, b));
    DEM_TRY(dem_scene_read_weight(dict, b, &weighs));
    b->weighs = !weighs ? 0.0 : b->rotation.density > 0.0 ? 1.0 : b->mass;    /* 1: times the mass to come */
    DEM_TRY(read_free_axes(dict, of, b));
    return read_translation(dict, of, b);
}
