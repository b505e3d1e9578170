/*
 * walls.h -- walls as flat regions: infinite planes, and triangles joined to the largest flat pieces.
 *
 * A contact with a wall is a contact with a region: coplanar triangles that hang together are one region, so a sphere
 * that slides over their seams keeps one contact with one memory. Regions are numbered from the sorted triangles, so
 * their numbers do not depend on the order in which triangles were handed in.
 *
 * Not here: which particles are near (space/wall_search), how near (step/wall_touch).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STATE_WALLS_H
#define DEM_STATE_WALLS_H

#include <stddef.h>
#include <stdint.h>

struct dem_wall
{
    char name[64];
    int material;
    int plane;                                            /* 1: one infinite, one-sided plane; 0: two-sided triangles */
    double normal[3], point[3];                           /* of a plane: unit, into the room of the particles; m */
};

struct dem_triangle
{
    double corner[3][3];                                  /* m */
    int wall, region;
    unsigned rim;                                         /* bit k: edge corner k -> k + 1 is on the rim of its region */
};

struct dem_region
{
    double normal[3], offset;                             /* n.x = offset on the plane; unit, m */
    int wall, one_sided;
};

struct dem_walls
{
    int walls;
    struct dem_wall *wall;
    size_t wall_room;
    size_t triangles, triangle_room;
    struct dem_triangle *triangle;
    int regions;
    struct dem_region *region;
    size_t region_room;
    double speed;                                         /* m/s, of the fastest wall: 0, all walls are at rest */
};

void dem_walls_free(struct dem_walls *);

/* Names must differ. Returns the wall's number through `wall`. */
int dem_walls_add(struct dem_walls *, const char *name, int material, int *wall);
int dem_walls_add_plane(struct dem_walls *, const char *name, int material, const double point[3], const double normal[3]);

/* n triangles, 9 numbers each; degenerate ones are dropped, exact repeats count once (see finish). */
int dem_walls_add_triangles(struct dem_walls *, int wall, size_t n, const double *corners);

/* Join triangles to regions. `scale` [m] is a length (a particle's radius) that decides what is flat. */
int dem_walls_finish(struct dem_walls *, double scale);

#endif
