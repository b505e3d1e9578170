/*
 * scene_parts.h -- the parts of a scene that have a file of their own; called by scene.c in this order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_SCENE_PARTS_H
#define DEM_IO_SCENE_PARTS_H

#include "io/scene.h"

/* The entry material of a wall or an insertion; where there is one only, it need not be given. */
int dem_scene_read_material_of(const struct dem_dict *, const struct dem_recipe *, int *material);

/* effects and pairs; materials (dem_scene_read_materials) have been read before. */
int dem_scene_read_recipe(const struct dem_dict *, struct dem_recipe *);

/* Walls made of the recipe's materials, behind those that were handed in by program. */
int dem_scene_read_walls(const struct dem_dict *, const struct dem_recipe *, struct dem_walls *);

/* motion, surfaceVelocity and surfaceRotation of one wall's entry */
int dem_scene_read_motion(struct dem_walls *, int wall, const struct dem_dict *);

#endif
