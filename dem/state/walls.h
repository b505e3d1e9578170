/*
 * walls.h -- walls as regions: infinite planes, cylinders, spheres, and triangles joined to the largest flat pieces.
 *
 * A contact with a wall is a contact with a region: coplanar triangles that hang together are one region, so a sphere
 * that slides over their seams keeps one contact with one memory. Regions are numbered from the sorted triangles, so
 * their numbers do not depend on the order in which triangles were handed in. Planes, cylinders and spheres are one
 * region each and have one side; triangles have two.
 *
 * A wall that moves keeps all of this in a frame of its own (wall_motion.h). One that follows a mesh has its triangles where they
 * are, but its regions from where they were handed in (wall_course.c).
 *
 * Not here: which particles are near (space/wall_search), how near (step/wall_touch).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STATE_WALLS_H
#define DEM_STATE_WALLS_H

#include "state/wall_motion.h"
#include <stddef.h>
#include <stdint.h>

enum dem_shape
{
    DEM_SHAPE_TRIANGLES,
    DEM_SHAPE_PLANE,
    DEM_SHAPE_CYLINDER,                                   /* without ends */
    DEM_SHAPE_SPHERE
};

struct dem_wall
{
    char name[64];
    int material;
    enum dem_shape shape;
    int outside;                                          /* cylinder, sphere: 1 when particles live outside of it */
    double normal[3];                                     /* unit: of a plane, into the room of the particles; axis of a cylinder */
    double point[3], radius;                              /* m: on the plane, on the axis, the centre */
    int moving;                                           /* number in dem_walls.moving, or -1: at rest */
    int driven;                                           /* 1: its surface runs in itself, at drive + spin x (x - origin) */
    double drive[3], drive_spin[3], drive_origin[3];      /* m/s, 1/s, m, all in the wall's frame */
    size_t triangles, flat, repeats;                      /* kept; dropped without area; dropped as exact repeats */
    size_t handed;                                        /* handed in */
    int follows, goes;                                    /* 1: it is told where to go; it goes somewhere in this advance */
    double way;                                           /* m: of its fastest corner in this advance */
};

struct dem_triangle
{
    double corner[3][3];                                  /* m */
    int wall, region;
    unsigned rim;                                         /* bit k: edge corner k -> k + 1 is on the rim of its region */
    uint32_t handed;                                      /* its number among those handed in for its wall */
};

struct dem_course                                         /* of a triangle: its corners at the begin and the end of this advance */
{
    double from[3][3], to[3][3];                          /* m */
};

struct dem_region                                         /* in the wall's frame */
{
    double normal[3], offset;                             /* n.x = offset on the plane; unit, m; n is a cylinder's axis */
    double centre[3], radius;                             /* m: of a cylinder (any point of its axis) or sphere */
    int wall, outside;
    enum dem_shape shape;
    int bent;                                             /* 1: it follows a mesh and its triangles lie in no plane any more */
    uint32_t largest;                                     /* triangle, of the undisturbed surface: its plane is the region's */
};

struct dem_moving                                         /* one motion, for all walls that share it */
{
    struct dem_motion motion;
    struct dem_pose pose;                                 /* now */
    struct dem_stride stride;                             /* over the last step */
    int triangles;                                        /* 1: a wall of triangles moves so */
};

enum dem_list                                             /* of neighbours, see space/pairs.h */
{
    DEM_LIST_OUTER,
    DEM_LIST_INNER,
    DEM_LISTS
};

enum dem_mark_counts                                      /* of the displacement of a mark */
{
    DEM_MARK_ALL,
    DEM_MARK_ALONG,                                       /* what lies along the normal of a plane */
    DEM_MARK_ACROSS                                       /* what lies across the axis of a cylinder */
};

struct dem_mark                                           /* no point of a wall moves further than the furthest of its marks */
{
    int moving;
    enum dem_mark_counts counts;
    double at[3], normal[3];                              /* m, unit, in the wall's frame */
    double then[DEM_LISTS][3], last[3];                   /* m, in the world: when lists were made, a step ago */
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
    int movings;
    struct dem_moving *moving;
    size_t moving_room;
    size_t marks, mark_room;
    struct dem_mark *mark;
    double stride;                                        /* m: the furthest that a wall has moved in the last step */
    int following;                                        /* walls that follow a mesh; what comes next is theirs */
    struct dem_course *course;                            /* one a triangle, or NULL */
    double flatness;                                      /* m: corners nearer to a plane than this are in it */
    double advance;                                       /* s: length of this advance */
    double journey, since[DEM_LISTS];                     /* m: no corner has come further, ever; since lists were made */
    int plain;                                            /* 1: all walls are flat and at rest, and so are their surfaces */
};

void dem_walls_free(struct dem_walls *);

/* Names must differ. Returns the wall's number through `wall`. */
int dem_walls_add(struct dem_walls *, const char *name, int material, int *wall);
int dem_walls_add_plane(struct dem_walls *, const char *name, int material, const double point[3], const double normal[3]);

/* The rest of what a cylinder or sphere is. `axis` is NULL for a sphere. */
int dem_walls_add_round(struct dem_walls *, const char *name, int material, const double point[3], const double *axis, double radius,
                        int outside);

/* n triangles, 9 numbers each; degenerate ones are dropped, exact repeats count once (see finish). */
int dem_walls_add_triangles(struct dem_walls *, int wall, size_t n, const double *corners);

/* Let a wall move; refused where its shape could not follow (an infinite plane turns about its normal only). */
int dem_walls_set_motion(struct dem_walls *, int wall, const struct dem_motion *);

/* Join triangles to regions. `scale` [m] is a length (a particle's radius) that decides what is flat. */
int dem_walls_finish(struct dem_walls *, double scale);

/* Part of the above: the points that tell how far walls have moved. */
int dem_walls_make_marks(struct dem_walls *);

/* Height [m] of x, in the wall's frame, over the whole surface of a region, negative behind it, and the unit normal there. */
double dem_region_height(const struct dem_region *, const double x[3], double normal[3]);

/* ---- motion: nothing where no wall moves ------------------------------------------------------------------------ */

/* x in the frame of a wall: x itself, or in `room`. */
const double *dem_walls_own(const struct dem_walls *, int wall, const double x[3], double room[3]);

/* Put all walls where they are at `time` [s]; the last step took dt [s], or 0. */
void dem_walls_move(struct dem_walls *, double time, double dt);

/* A list of neighbours is being made now. */
void dem_walls_remark(struct dem_walls *, enum dem_list);

/* How far [m] the furthest wall has moved since, as seen by who has moved by `drift` [m]; a way that leaves a wall in itself does not count. */
double dem_walls_moved(const struct dem_walls *, enum dem_list, const double drift[3]);

/* ---- following a mesh: nothing where no wall does ---------------------------------------------------------------- */

/* Corners of a wall's triangles in the order in which they were handed in, after the walls are finished: where they are now, or
   will be at the end of the next advance. A wall that is not told stays where it is. */
int dem_walls_place(struct dem_walls *, int wall, size_t n, const double *corners);
int dem_walls_tell(struct dem_walls *, int wall, size_t n, const double *corners);

/* An advance of `duration` [s] begins; `step` of its `steps` equal steps are done; back to where it began. */
void dem_walls_set_off(struct dem_walls *, double duration);
void dem_walls_go(struct dem_walls *, int64_t step, int64_t steps);
void dem_walls_go_back(struct dem_walls *);

/* Velocity [m/s] of the point x of a triangle and angular velocity [1/s] of the surface there, in this advance. */
void dem_walls_drift(const struct dem_walls *, uint32_t triangle, const double x[3], double velocity[3], double spin[3]);

#endif
