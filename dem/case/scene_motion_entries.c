/*
 * scene_motion_entries.c -- read what several motions of walls have: times, a direction, a table.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/scene_internal.h"
#include "core/did_you_mean.h"
#include "core/error.h"
#include "core/vec.h"
#include <math.h>
#include <string.h>

int dem_scene_read_direction(const struct dem_dict *dict, double axis[3])
{
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

int dem_scene_read_times(const struct dem_dict *dict, double *start, double *end, int16_t stage[2])
{
    int from, to;

    DEM_TRY(dem_dict_time_or(dict, "start", 0.0, start, &from));
    DEM_TRY(dem_dict_time_or(dict, "end", INFINITY, end, &to));
    stage[0] = (int16_t)from;
    stage[1] = (int16_t)to;
    DEM_REQUIRE(from || fabs(*start) < DEM_MOTION_LIMIT, DEM_ERROR_INPUT,
                "%s: start %g s; give a time within %g s of 0", dem_dict_where(dict), *start,
                DEM_MOTION_LIMIT);
    return dem_dict_check_times(dict, "start", "end", (const double[2]){*start, *end}, (const int[2]){from, to});
}

int dem_scene_read_time_table(const struct dem_dict *dict, const char *const *names, int n,
                              struct dem_time_table **table)
{
    static const char *const ways[] = {"smooth", "linear"};
    const char *file, *way;

    DEM_TRY(dem_dict_text(dict, "file", &file));
    DEM_TRY(dem_dict_word_or(dict, "interpolation", ways[0], &way));
    const int smooth = strcmp(way, ways[0]) == 0;

    if (!smooth && strcmp(way, ways[1]) != 0)
    {
        return dem_error_prefix(dem_did_you_mean_error("interpolation", way, ways, 2),
                                "%s: ", dem_dict_where(dict));
    }
    return dem_error_prefix(dem_time_table_read(table, file, names, n, smooth),
                            "%s: ", dem_dict_where(dict));
}
