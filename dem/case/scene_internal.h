/*
 * scene_internal.h -- internal interface of the files scene*.c: readers of the entries that have a
 * file of their own, in the order in which scene.c calls them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "case/scene.h"

/* The entries effects and pairs; call dem_scene_read_materials before. */
int dem_scene_read_interactions(const struct dem_dict *, struct dem_interaction_table *);

/* The entry walls; appended to those that were added through the API. */
int dem_scene_read_walls(const struct dem_dict *, const struct dem_interaction_table *,
                         struct dem_walls *);

/* A table of quantities over time, from `file` and `interpolation`; its columns besides time. */
int dem_scene_read_time_table(const struct dem_dict *, const char *const *names, int n,
                              struct dem_time_table **);

/* The entry axis as a unit vector. */
int dem_scene_read_direction(const struct dem_dict *, double axis[3]);

/* start and end of a motion [s], and the stages that begin then, from 1, or 0. */
int dem_scene_read_times(const struct dem_dict *, double *start, double *end, int16_t stage[2]);

/* A motion by force; *body stays NULL for another type. The caller frees it, also after an error. */
int dem_scene_read_body(const struct dem_dict *, const char *type, const struct dem_wall *,
                        struct dem_wall_body **body);

/* motion, surfaceVelocity and surfaceRotation of one wall. */
int dem_scene_read_motion(struct dem_walls *, int wall, const struct dem_dict *);

/* The entry fluid; the effects say which of its entries they need. */
int dem_scene_read_fluid(struct dem_uniform_fluid *, const struct dem_dict *scene,
                         const struct dem_interaction_table *);

/* The settings of rest, with their defaults where there is no dictionary (NULL). */
struct dem_quiet;
int dem_scene_read_quiet(const struct dem_dict *, struct dem_quiet *);
