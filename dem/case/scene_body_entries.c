/*
 * scene_body_entries.c -- read the entries that several kinds of walls moved by force have: loads, damping, weight.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/scene_body_entries.h"
#include "core/error.h"
#include "walls/wall_motion.h"

int dem_scene_read_load_table(const struct dem_dict *dict, const char *name, const struct dem_wall_body *b,
                           struct dem_time_table **to)
{
    static const char *const vector[] = {"x", "y", "z"}, *const number[] = {"value"};
    const struct dem_dict *sub;

    DEM_TRY(dem_dict_sub(dict, name, &sub));
    return b->kind == DEM_WALL_BODY_FREE ? dem_scene_read_time_table(sub, vector, 3, to)
                                         : dem_scene_read_time_table(sub, number, 1, to);
}

int dem_scene_read_load(const struct dem_dict *dict, const char *name, const char *unit,
                     struct dem_wall_body *b)
{
    static const double zero[3] = {0.0, 0.0, 0.0};

    if (dem_dict_has_dict(dict, name))
    {
        return dem_scene_read_load_table(dict, name, b, &b->table);
    }
    return b->kind == DEM_WALL_BODY_FREE ? dem_dict_vector_or(dict, name, unit, zero, b->force)
           : b->kind == DEM_WALL_BODY_SERVO ? dem_dict_number(dict, name, unit, &b->force[0])
                                            : dem_dict_number_or(dict, name, unit, 0.0, &b->force[0]);
}

int dem_scene_read_positive(const struct dem_dict *dict, const char *name, const char *unit, double *value)
{
    DEM_TRY(dem_dict_number(dict, name, unit, value));
    DEM_REQUIRE(*value > 0.0 && *value < DEM_MOTION_LIMIT, DEM_ERROR_INPUT,
                "%s: %s: %s %g %s; give a number above 0 and below %g", PLACE(dict), name, *value,
                unit, DEM_MOTION_LIMIT);
    return DEM_OK;
}

int dem_scene_read_damping(const struct dem_dict *dict, const char *unit, double least,
                        struct dem_wall_body *b)
{
    DEM_TRY(dem_dict_number_or(dict, "damping", unit, least, &b->damping));
    DEM_REQUIRE(b->damping >= 0.0 || !dem_dict_has(dict, "damping"), DEM_ERROR_INPUT,
                "%s: %s: damping %g %s; give a number above or equal to 0", PLACE(dict), b->damping,
                unit);
    return DEM_OK;
}

int dem_scene_read_weight(const struct dem_dict *dict, struct dem_wall_body *b, int *weighs)
{
    bool weight;

    DEM_TRY(dem_dict_switch_or(dict, "weight", true, &weight));
    b->weight_given = dem_dict_has(dict, "weight");
    *weighs = weight;
    return DEM_OK;
}
