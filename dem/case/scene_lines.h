/*
 * scene_lines.h -- two scenes as lines "path value" (dem_dict_flatten), to be compared, and what a
 * difference means for a restart.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <stddef.h>

struct dem_scene_line
{
    const char *path, *value;     /* not ended by zeros */
    size_t length, size;          /* of the path, of the value */
};

struct dem_scene_lines
{
    struct dem_scene_line *line;
    size_t n;
};

enum dem_line_change
{
    DEM_LINE_CHANGED, DEM_LINE_NEW, DEM_LINE_GONE
};

/* Take a text apart and sort its lines by path, those with @ left out. The lines point into the text;
   free the array `line`. */
int dem_scene_lines_split(const char *text, struct dem_scene_lines *);

/* The order of the lines: a / comes before all else. */
int dem_scene_lines_compare(const void *, const void *);

/* 1 when the values have the same words and numbers. */
int dem_scene_lines_same(const struct dem_scene_line *, const struct dem_scene_line *);

/* Component k of a path, from 0, into `part`; "" behind the last. */
const char *dem_scene_line_part(const struct dem_scene_line *, int k, char part[64]);

/* 1 when an entry of a wall gives its form or place; when the group of `insert` that the line belongs to
   is a stream. */
int dem_scene_line_is_form(const char *entry);
int dem_scene_line_is_stream(const struct dem_scene_lines *all, const struct dem_scene_line *);

/* What becomes of a difference at a restart, as the end of a sentence. `all`: the scene of the line. */
const char *dem_scene_line_becomes(const struct dem_scene_lines *all, const struct dem_scene_line *,
                                   enum dem_line_change);
