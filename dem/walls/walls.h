/*
 * walls.h -- walls: infinite planes, cylinders, spheres and triangulated surfaces, divided into
 * facets.
 *
 * A contact with a wall is a contact with a facet. Coplanar triangles that are connected form one
 * facet, so a sphere that slides over their common edges keeps one contact with one history. Facets
 * are numbered from the sorted triangles, so their numbers do not depend on the order in which
 * triangles were given. Planes, cylinders and spheres are one facet each and have one side;
 * triangles have two.
 *
 * Along periodic axes triangles have images: facets continue through a periodic face, and a
 * particle touches whatever image is near. No image is stored: a particle is compared with a
 * triangle at its own position less a whole number of periods (wall_images.c).
 *
 * A moving wall is stored in its own reference frame (wall_motion.h). A wall that follows a mesh
 * has its triangles at their present positions, but keeps the facets of the surface that was given
 * (wall_trajectory.c).
 *
 * With several ranks, each holds the triangles near its particles and their facets, in global order
 * and with global numbers (wall_records.c); ranks/wall_store.h selects them.
 *
 * Search for particles near walls: walls/wall_search.h; contact points: walls/wall_touch.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/name_index.h"
#include "walls/compound_motion.h"
#include "walls/facet.h"
#include "walls/facet_image.h"
#include "walls/wall_drive.h"
#include "walls/wall_motion.h"
#include <stddef.h>
#include <stdint.h>

/* condition of a wall for a particle scalar; all zero: insulated */
struct dem_wall_scalar
{
    int given;                    /* 1: effects see `value` at the wall */
    double value;                 /* unit */
    double flux;                  /* unit C/(s m2)  into a particle that touches it, on pi R^2 */
    double film;                  /* C/(s m2)       coefficient from `value`, likewise */
    double start, end;            /* s  when it acts; insulated at other times */
};

enum
{
    DEM_WALL_FORM = 7             /* numbers that describe the form of a wall */
};

struct dem_wall
{
    char name[64];
    int material;
    /* 1: contacts have the normal force and its damping only */
    int frictionless;
    enum dem_shape shape;
    /* cylinder, sphere: 1 when particles are outside */
    int outside;
    /* unit: of a plane, towards the particles; axis of a cylinder */
    double normal[3];
    /* m: on the plane, on the axis, the centre */
    double point[3], radius;
    /* index of its reference frame in dem_walls, or -1: at rest */
    int frame;
    /* 1: the surface slides in itself (conveyor) */
    int driven;
    struct dem_wall_drive drive;
    /* 1/Pa: coefficient of wear over hardness; 0: wear is not summed */
    double wear;
    /* 1: of impacts (Finnie), 0: of sliding (Archard) */
    int wears_by_impact;
    /* name of the entry of the scene that makes it absorb particles, or NULL */
    const char *absorbs;
    /* s: it is there from the first to the second time; the stages that begin then, from 1, or 0 */
    double there[2];
    int there_stage[2];
    /* 1: it is not there now; it has come just now */
    int absent, came;
    /* one for each particle scalar; NULL: insulated for all */
    struct dem_wall_scalar *scalars;
    /* its index among the outlets, which counts them */
    int outlet;
    /* of all ranks: kept; dropped without area; dropped duplicates */
    size_t triangles, flat, repeats;
    /* m2, m: of its triangles, in its frame */
    double area, centroid[3];
    /* triangles given, before any are dropped */
    size_t given;
    /* numbers of its facets: these */
    int first_facet, facets;
    /* m/s: largest speed along its own normal that its motion gives to its surface */
    double push;
    /* 1: it follows a mesh; it moves in this advance */
    int follows_mesh, moves;
    /* m: largest displacement of a corner, this advance */
    double displacement;
};

struct dem_triangle
{
    /* m */
    double corner[3][3];
    /* its index among the facets held */
    int facet;
    /* its index among the triangles of all walls and ranks, sorted */
    uint32_t index;
    /* its index among the triangles given for its wall */
    uint32_t given_index;
    uint16_t wall;
    /* bit k: edge k -> k + 1 is on the rim of its facet */
    uint8_t rim;
    /* shift code: periods from here to its place in the facet, which is connected */
    uint8_t place;
};

/* corners of a triangle at begin and end of an advance */
struct dem_corner_trajectory
{
    double from[3][3], to[3][3];  /* m */
};

/* a triangle and the plane of its facet, as one rank hands it to another */
struct dem_wall_record
{
    struct dem_triangle triangle;  /* facet: its number */
    double normal[3], offset;      /* of the facet, in the wall's frame */
    uint32_t largest;
    uint16_t bent;
    uint8_t endless, distinct;
};

/* reference frame of all walls with the same motion and base */
struct dem_wall_frame
{
    struct dem_motion motion;
    struct dem_compound_motion *compound;  /* of DEM_MOTION_COMPOUND; of this wall alone */
    struct dem_pose base;         /* where the motion begins, see wall_motion.h */
    int resumed;                  /* 1: the base is not the identity */
    struct dem_pose pose;         /* present */
    struct dem_wall_displacement displacement;  /* over the last step */
    int triangles;                /* 1: has a wall of triangles */
    double box[2][3];             /* m: of these, in the frame */
    double period[3];             /* m: of the images of its triangles; 0: none along this axis */
    double turns[3];              /* whole periods taken off the displacement of the frame */
};

enum dem_list                                             /* neighbor lists, see contacts/pairs.h */
{
    DEM_LIST_OUTER,
    DEM_LIST_INNER,
    DEM_LISTS,
    DEM_LIST_TRIANGLES = DEM_LISTS,  /* of marks only: the triangles that a rank holds */
    DEM_MARK_REFERENCES
};

enum dem_mark_counts                                      /* of the displacement of a mark */
{
    DEM_MARK_ALL,
    DEM_MARK_ALONG,               /* only the component normal to a plane */
    DEM_MARK_ACROSS               /* only the component across the axis of a cylinder */
};

/* The displacement of any point of a wall is at most the largest displacement of its marks. */
struct dem_mark
{
    int frame;                               /* index of the reference frame */
    enum dem_mark_counts counts;
    double at[3], normal[3];                  /* m, unit, in the wall's frame */
    double reference[DEM_MARK_REFERENCES][3];  /* m, global: when lists were made */
    double last[3];                           /* m, global: a step ago */
};

struct dem_walls
{
    int walls;
    struct dem_wall *wall;
    size_t wall_capacity;
    /* of walls */
    struct dem_name_index names;
    size_t triangles, triangle_capacity;
    struct dem_triangle *triangle;
    int facets;
    struct dem_facet *facet;
    size_t facet_capacity;
    int frames;
    struct dem_wall_frame *frame;
    size_t frame_capacity;
    size_t marks, mark_capacity;
    struct dem_mark *mark;
    /* m: largest displacement of a wall in the last step */
    double displacement;
    /* number of frames that are moved by force */
    int bodies;
    /* number of walls that follow a mesh */
    int following;
    /* of walls that follow a mesh: one per triangle, or NULL */
    struct dem_corner_trajectory *trajectory;
    /* m: tolerance for corners to be in a plane */
    double flatness;
    /* s: length of this advance */
    double advance;
    /* m: bound of the path of corners in the whole run */
    double path_length;
    /* m: the same since lists were made */
    double since[DEM_MARK_REFERENCES];
    /* number of walls that absorb particles; whose wear is summed; that are not there all the time */
    int absorbing, wearing, passing;
    /* 1: all walls are flat and at rest, none is driven */
    int all_flat_static;
    /* 1: triangles are given on another rank */
    int elsewhere;
    /* 1: triangles have periodic images */
    int periodic;
    /* m: of periodic axes, else 0; positions along them are multiples of the unit */
    double period[3], unit[3];
    /* m: the periodic faces */
    double face[2][3];
    /* m: what is further from a periodic face is not compared with particles beyond it */
    double reach;
};

void dem_walls_free(struct dem_walls *);

/* Index of the wall of this name; the number of walls when there is none. */
int dem_walls_named(const struct dem_walls *, const char *name);

/* Add a wall of triangles, or a plane. Names must be unique (DEM_ERROR_INPUT). `wall`: index of the
   wall. */
int dem_walls_add(struct dem_walls *, const char *name, int material, int *wall);
int dem_walls_add_plane(struct dem_walls *, const char *name, int material, const double point[3],
                        const double normal[3]);

/* Add a cylinder without ends, or a sphere (`axis` NULL). outside: 1 when the particles are
   outside. */
int dem_walls_add_round(struct dem_walls *, const char *name, int material, const double point[3],
                        const double *axis, double radius, int outside);

/* Add n triangles to a wall, 9 numbers [m] each, unless they are given elsewhere; dem_walls_finish
   drops degenerate ones and duplicates. */
int dem_walls_add_triangles(struct dem_walls *, int wall, size_t n, const double *corners);

/* Give a wall a motion. DEM_ERROR_INPUT when its shape cannot follow (an infinite plane can rotate
   about its normal only). */
int dem_walls_set_motion(struct dem_walls *, int wall, const struct dem_motion *);

/* Likewise a motion of several parts, from a table or by force, which the walls own from now on, also
   after an error. */
int dem_walls_set_compound(struct dem_walls *, int wall, struct dem_compound_motion *);

/* what a snapshot knows of the motion of a wall */
struct dem_wall_before
{
    struct dem_motion motion;
    struct dem_pose base;
    int compound;                 /* 1: of the motion these only: */
    struct dem_motion_hash hash;
    struct dem_pose stood;
    struct dem_wall_body_state body;
};

/* Before the walls are finished: a wall that had another motion until `time` [s] goes on from its pose
   then, with its motion from now on. The same motion keeps the base; a
   body on the same axes keeps its state. *rows: 1 when only the rows of its tables have changed. */
int dem_walls_resume_motion(struct dem_walls *, int wall, const struct dem_wall_before *,
                            double time, int *rows);

/* The axis [unit] and a point on it [m] about which a wall or its surface turns. Returns 0, and the z
   axis, for a wall that does not turn about one axis fixed in space. */
int dem_walls_axis(const struct dem_walls *, int wall, double origin[3], double axis[3]);

/* The pose of a frame at a time [s]; of a body, with its present displacement. */
void dem_wall_frame_pose(const struct dem_wall_frame *, double time, struct dem_pose *);

/* The body of a wall that is moved by force, or NULL. */
struct dem_wall_body *dem_walls_body(const struct dem_walls *, int wall);

/* After the walls are finished: normal or axis, point, radius; or area and centroid of triangles.
   dem_walls_same_form: 1 when two of them are of the same wall. Triangles may differ by the rounding
   of a file that was written with six digits. */
void dem_walls_form(const struct dem_wall *, double form[DEM_WALL_FORM]);
int dem_walls_same_form(const double *a, const double *b, int triangles);

/* Join triangles to facets. `scale` [m]: the largest particle radius, from which the tolerances of
   welding and flatness follow. */
int dem_walls_finish(struct dem_walls *, double scale);

/* Part of the above: a facet has the plane of this triangle, with the area vector `area` of
   length `size` [m2]. Without an area the normal stays. */
void dem_walls_set_plane(const struct dem_walls *, struct dem_facet *, const struct dem_triangle *,
                         double size, const double area[3]);

/* Part of the above: choose the points whose displacements bound the displacements of
   the walls. */
int dem_walls_make_marks(struct dem_walls *);

/* Part of it: the speeds with which motions push particles. */
void dem_walls_find_push(struct dem_walls *);

/* ---- periodic images: no effect without periodic axes ----------------------------------------- */

/* The period [m] of the images of triangles with this reference frame, -1: at rest. */
static inline const double *dem_walls_period(const struct dem_walls *w, int frame)
{
    return frame < 0 ? w->period : w->frame[frame].period;
}

/* Whole periods taken off a wall's displacement, for the keys of its contacts. */
void dem_walls_turns(const struct dem_walls *, int wall, int turns[3]);

/* A corner of a triangle at its place in the facet. */
void dem_walls_place_corner(const struct dem_walls *, const struct dem_triangle *, int k,
                            double corner[3]);

/* Part of dem_walls_finish: how facets lie to their own images, `endless` and `distinct`. */
int dem_walls_compare_images(struct dem_walls *);

/* Once boxes and motions of reference frames are known: which of these have periodic images. */
void dem_walls_choose_periods(struct dem_walls *);

/* Round the pose of a frame that has images, so that these are exact, and take the turns off. */
void dem_walls_make_pose_periodic(const struct dem_walls *, struct dem_wall_frame *);

/* When lists are made: take whole periods off the displacements of frames. */
void dem_walls_wrap(struct dem_walls *);

/* Triangles of all walls and ranks. */
size_t dem_walls_count_triangles(const struct dem_walls *);

/* The wall that has the facet of this number. */
int dem_walls_with_facet(const struct dem_walls *, int number);

/* ---- a part of the triangles ----------------------------------------------------------------- */

/* The record of a triangle held. */
void dem_walls_record(const struct dem_walls *, size_t triangle, struct dem_wall_record *);

/* Where the triangle that has this index among all is among those held. */
size_t dem_walls_find(const struct dem_walls *, uint32_t index);

/* Hold the triangles of the records and, as before, of walls that follow a mesh; no others. */
int dem_walls_hold(struct dem_walls *, size_t n, const struct dem_wall_record *);

/* The same in `part`, which shares all but triangles and facets with the walls;
   dem_walls_free_part frees these. */
int dem_walls_copy_part(const struct dem_walls *, size_t n, const struct dem_wall_record *,
                        struct dem_walls *part);
void dem_walls_free_part(struct dem_walls *part);

/* Bounding box [m] of a triangle at its present position, in the global frame. */
void dem_walls_triangle_box(const struct dem_walls *, const struct dem_triangle *,
                            double box[2][3]);

/* ---- walls that are not there all the time ---------------------------------------------------- */

/* Update which walls are there at this time [s]. Returns 1 if one has come or gone: lists must be made
   anew. */
int dem_walls_come_and_go(struct dem_walls *, double time);

/* The first time after this one [s] at which a wall comes or goes, as far as it is known; infinite: none. */
double dem_walls_next_change(const struct dem_walls *, double time);

/* ---- motion: no effect when no wall moves ---------------------------------------------------- */

/* x in the frame of a wall: x itself, or written to `own`. */
const double *dem_walls_to_frame(const struct dem_walls *, int wall, const double x[3],
                                 double own[3]);

/* Move all walls to their poses at `time` [s]; dt [s]: length of the last step, or 0. */
void dem_walls_move(struct dem_walls *, double time, double dt);

/* Store the present positions as the reference of a neighbor list that is being made. */
void dem_walls_reset_marks(struct dem_walls *, enum dem_list);

/* Largest displacement [m] of a wall since the list was made, relative to the displacement `drift`
   [m]; displacements of a wall within its own surface do not count. */
double dem_walls_max_displacement(const struct dem_walls *, enum dem_list, const double drift[3]);

/* ---- following a mesh: no effect when no wall does ------------------------------------------- */

/* Set the corners [m] of a wall's triangles, in the order in which they were given, after the walls
   are finished: their present positions (first function), or those at the end of the next advance
   (second). A wall whose corners are not set stays where it is. */
int dem_walls_set_corners(struct dem_walls *, int wall, size_t n, const double *corners);
int dem_walls_set_target(struct dem_walls *, int wall, size_t n, const double *corners);

/* Begin an advance of `duration` [s]; move to the end of step `step` of `steps` equal ones; return
   to its begin. */
void dem_walls_begin_advance(struct dem_walls *, double duration);
void dem_walls_advance(struct dem_walls *, int64_t step, int64_t steps);
void dem_walls_rewind(struct dem_walls *);

/* Velocity [m/s] of the point x of a triangle and angular velocity [1/s] of the surface there in
   this advance. */
void dem_walls_surface_motion(const struct dem_walls *, uint32_t triangle, const double x[3],
                              double velocity[3], double spin[3]);
