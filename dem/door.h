/*
 * door.h -- struct dem, shared by the files of the door: dem.c and look.c (the calls), ready.c (how a scene becomes a state, with
 * ready_walls.c and ready_particles.c), check.c (what can be told of it before).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_DOOR_H
#define DEM_DOOR_H

#include "dem.h"
#include "io/scene.h"
#include "io/snapshot.h"
#include "plan/plan.h"
#include "step/parts.h"

enum
{
    DEM_HEADING = 9                                       /* letters of "effects: ", which words of effects follow */
};

struct dem_mesh_wall                                          /* a wall handed in before the scene is read */
{
    char name[64], material[48];
    size_t n;
    double *triangles, *now;                                  /* now: where it stands, NULL: there */
};

struct dem_patch                                              /* of a mesh, from all ranks: n times 9 corners and 3 velocities */
{
    char name[64];
    size_t n;
    double *triangles;
};

struct dem
{
    struct dem_parts parts;
    struct dem_scene scene;
    struct dem_dict *dict;
    struct dem_crowd crowd;                               /* handed in by program; material is resolved at ready */
    char (*crowd_material)[48];
    size_t crowd_room;
    struct dem_mesh_wall *mesh_wall;
    size_t mesh_walls, mesh_wall_room;
    struct dem_patch *patch;
    size_t patches, patch_room;
    struct dem_goer *goer;                                /* whom the program takes out next */
    size_t goers, goer_room;
    int between;                                          /* 1: streams and outlets act between advances */
    char load[1024];
    int checked;                                          /* 1: dem_check found nothing, -1: it found something */
    int ready, with_fluid, coupled;
    int new;                                              /* 1: the scene's `start` is where it begins */
    int restored;                                         /* 1: gone back to a copy; means are those of later times */
    int broken;                                           /* 1: the last dem_advance left the ranks apart */
    int energy;                                           /* 1: the ledger was asked for */
    int turned;                                           /* 1: orientations were asked for */
    int feels_gradient;                                   /* 1: pressureGradient is among the effects */
    struct dem_skins learnt;                              /* what the snapshot knows of the lists */
    struct dem_snapshot flowed;                           /* and of streams and outlets */
    struct dem_flow flow[DEM_SNAPSHOT_FLOWS];             /* as told last */
    double step;                                          /* s, the limit in force */
    struct dem_text plan, profile;                        /* the last ones */
    struct dem_verdicts verdicts;                         /* of that plan */
    char heading[DEM_HEADING + 800], in_fluid[400];                     /* of results, with words of all effects; those of the fluid */
};

/* An error when this call comes after dem_check or dem_ready. */
int dem_door_early(const struct dem *, const char *call);

/* Collective. All ranks fail when one does. */
int dem_door_together(const struct dem *, int status);

/* Collective. n items of `size` numbers from each rank, in the order of the ranks. */
int dem_door_gather(const struct dem_parts *, size_t size, size_t n, const double *mine, double **items, size_t *number);

/* Hand the patches that are known to the streams that come through them. */
int dem_door_take_patches(struct dem *);

/* Collective. Tell a wall where its triangles will be at the end of the next advance; `now`: where they are. */
int dem_door_tell_wall(struct dem *, const struct dem_mesh_wall *, int now);

/* Collective. Walls that were handed in join those of the scene; where those that follow a mesh are now. */
int dem_door_take_walls(struct dem *);
int dem_door_place_walls(struct dem *);

/* Collective. A share of the particles for every rank; their radii for the recipe; the fluid around them. */
int dem_door_start_particles(struct dem *);
void dem_door_survey_radii(struct dem_parts *);
void dem_door_fill_fluid(struct dem *);
int dem_door_begin_flows(struct dem *);                   /* collective */

/* What can be told before particles are placed: the scene has been read, walls are there. */
int dem_door_examine(struct dem *);

/* When all radii are known: freeze the recipe, choose the step, finish the walls. */
int dem_door_settle_physics(struct dem *);
double dem_door_most_radius(const struct dem *);          /* m */

/* Collective. Read the scene and examine it, place no particles. */
int dem_door_read(struct dem *);

/* Collective. Make particles, hand them to ranks. */
int dem_door_get_ready(struct dem *);

#endif
