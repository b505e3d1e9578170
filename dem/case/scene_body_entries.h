/*
 * scene_body_entries.h -- what the readers of walls moved by force share (scene_bodies.c, scene_free_wall.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "case/scene_internal.h"

/* For "%s: %s: ": the line, and walls/NAME/motion. */
#define PLACE(dict) dem_dict_where(dict), dem_dict_path(dict)

/* A vector for a free wall, else a number; or a table. */
int dem_scene_read_load(const struct dem_dict *, const char *name, const char *unit, struct dem_wall_body *);
int dem_scene_read_load_table(const struct dem_dict *, const char *name, const struct dem_wall_body *,
                              struct dem_time_table **);

int dem_scene_read_positive(const struct dem_dict *, const char *name, const char *unit, double *value);

/* `least`: the value without the entry. */
int dem_scene_read_damping(const struct dem_dict *, const char *unit, double least, struct dem_wall_body *);

/* *weighs: 0 when the wall has no weight. */
int dem_scene_read_weight(const struct dem_dict *, struct dem_wall_body *, int *weighs);

int dem_scene_read_free(const struct dem_dict *, const struct dem_wall *, struct dem_wall_body *);
