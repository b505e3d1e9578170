/*
 * snapshot_scene.h -- what a snapshot knows of the scene that wrote it, for the comparison at a
 * restart: the text of its entries, its walls with their poses, its domain, the next free id.
 *
 * It is the last part of the caller's data, behind the averages:
 *
 *   1. struct dem_snapshot_wall, stored raw, one a wall
 *   2. text: lines, filled with zeros to whole 8-byte words
 *   3. struct dem_snapshot_scene_tail, stored raw: the sizes of 1 and 2
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "records/snapshot_header.h"
#include "walls/walls.h"

enum
{
    DEM_SNAPSHOT_SCENE_SPANS = 3
};

struct dem_snapshot_wall
{
    char name[64];
    int64_t shape, outside, first_facet, facets, triangles;
    double form[DEM_WALL_FORM];
    struct dem_motion motion;
    struct dem_pose base;         /* of its frame, before the motion */
};

struct dem_snapshot_scene_tail
{
    int64_t walls, text;          /* number of walls, bytes of text */
    int64_t next_id;              /* the first id that no particle has had */
    double domain[3][3];          /* of each axis: 1 when periodic, its limits [m] */
};

struct dem_snapshot_scene
{
    struct dem_snapshot_scene_tail tail;
    struct dem_snapshot_wall *wall;
    char *text;                   /* lines of dem_dict_flatten, and one for each group that
                                     was inserted */
};

void dem_snapshot_scene_free(struct dem_snapshot_scene *);

/* The record of a wall. */
struct dem_snapshot_wall dem_snapshot_scene_wall(const struct dem_walls *, int wall);

/* The parts of the scene as data of the caller; the scene must outlive them. The tail gets its
   sizes. */
void dem_snapshot_scene_spans(struct dem_snapshot_scene *, struct dem_span *);

/* Collective. The scene of a file whose checksum is right; DEM_ERROR_FILE when it is inconsistent.
   dem_snapshot_scene_free frees it. */
int dem_snapshot_read_scene(const char *path, const struct dem_decomposition *,
                            struct dem_snapshot_scene *);

/* Bytes of the scene at the end of the caller's data of an open file. */
int dem_snapshot_scene_size(struct dem_parallel_file *, const struct dem_snapshot_header *,
                            struct dem_snapshot_scene_tail *, size_t *size);
