/*
 * wall_store.h -- distributes the triangles of walls: each rank holds those near its particles.
 *
 * 1. Triangles are given on the first rank, which joins them to facets (walls/wall_facets.c). All
 *    ranks learn what is known of each wall (dem_wall_store_finish).
 * 2. Each rank stores a slice of the sorted triangles, 128 bytes each, for the whole run
 *    (dem_wall_store_distribute).
 * 3. When neighbor lists are rebuilt, each rank sends the triangles of its slice to the ranks whose
 *    subdomains they are near (dem_wall_store_select). Between rebuilds only triangles that the
 *    search found are read, so no motion of a wall has to be foreseen. A rank gets more
 *    triangles than it needs, and new ones only when these may no longer suffice.
 *
 * A wall that follows a mesh is held by all ranks (dem_wall_store_follow): the plane of a facet, and
 * whether it is bent, follow in each step from all of its triangles.
 *
 * With one rank these functions do nothing: it holds all triangles. Indices, numbers of facets and
 * the order of triangles are global, so contacts do not depend on what a rank holds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/domain.h"
#include "particles/particles.h"
#include "walls/walls.h"
#include "ranks/decomposition.h"
#include "ranks/sparse_exchange.h"

enum
{
    /* doubles of the record of a triangle in messages */
    DEM_WALL_STORE_RECORD = (int)(sizeof(struct dem_wall_record)/sizeof(double))
};
_Static_assert(sizeof(struct dem_wall_record)%sizeof(double) == 0,
               "the record of a triangle is sent as doubles");

struct dem_wall_store
{
    struct dem_decomposition *decomposition;
    int first_only;                  /* 1: triangles are given on the first rank only, 0: on all */
    size_t n;
    struct dem_wall_record *record;  /* slice of this rank */
    struct dem_messages out, in;
    double box[2][3], reach;         /* m: held are the triangles within reach of the particles of
                                        this rank when these had this bounding box on all ranks */
    int64_t selections;              /* number of selections so far */
};

void dem_wall_store_init(struct dem_wall_store *, struct dem_decomposition *);
void dem_wall_store_free(struct dem_wall_store *);

/* Bytes held, with the triangles and facets. */
size_t dem_wall_store_bytes(const struct dem_wall_store *, const struct dem_walls *);

/* Before triangles are added: they are given on the first rank only, or `everywhere`. */
void dem_wall_store_begin(struct dem_wall_store *, struct dem_walls *, int everywhere);

/* Collective. Add n triangles of this rank to a wall, 9 numbers [m] each. */
int dem_wall_store_add(struct dem_wall_store *, struct dem_walls *, int wall, size_t n,
                       const double *corners);

/* Collective, after dem_walls_finish, which returned `status` on this rank: all ranks fail, or know
   numbers of triangles and facets and the bounds of moving walls. */
int dem_wall_store_finish(struct dem_wall_store *, int status, struct dem_walls *);

/* Collective. Store the slices; no rank holds triangles then. */
int dem_wall_store_distribute(struct dem_wall_store *, struct dem_walls *);

/* Collective, after a migration. Hold the triangles within `reach` [m] of the particles of this
   rank. `status`: of this rank; one that has failed takes part. changed: 1 when other triangles are
   held than before. */
int dem_wall_store_select(struct dem_wall_store *, int status, struct dem_walls *,
                          const struct dem_particles *, double reach, int *changed);

/* A new decomposition: the next selection sends. */
void dem_wall_store_expire(struct dem_wall_store *);

/* Collective. Hold all triangles of a wall, which is to follow a mesh, besides those held. */
int dem_wall_store_follow(struct dem_wall_store *, struct dem_walls *, int wall);

/* Collective. `near` becomes the walls with the triangles within `reach` [m] of a box, or of its
   periodic images, the same on all ranks; dem_walls_free_part frees it. */
int dem_wall_store_gather(const struct dem_wall_store *, int status, const struct dem_walls *,
                          const struct dem_domain *, double box[2][3], double reach,
                          struct dem_walls *near);

/* Collective. The present corners [m] of all triangles of a wall, 9 numbers each, in the order of
   their index, on the first rank; `corners` is not used on the others. */
int dem_wall_store_corners(struct dem_wall_store *, const struct dem_walls *, int wall,
                           double *corners);

/* Collective. Exchange the messages; then `out` and its memory are not needed any more. Read `in`,
   then drop it. */
int dem_wall_store_exchange(struct dem_wall_store *, int status);
void dem_wall_store_drop_received(struct dem_wall_store *);
