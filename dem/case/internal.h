/*
 * internal.h -- struct dem and the functions that the files of case/ and run/ share.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_CASE_INTERNAL_H
#define DEM_CASE_INTERNAL_H

#include "dem.h"
#include "case/scene.h"
#include "records/totals.h"
#include "records/snapshot_scene.h"
#include "core/text.h"
#include "step/attached_stores.h"
#include "ranks/dem_state.h"

enum
{
    DEM_HEADING = 9  /* length of "effects: " in front of the names of effects */
};

/* a wall of dem_add_wall: the triangles of this rank */
struct dem_mesh_wall
{
    char name[64], material[48];
    size_t n;
    double *triangles, *moved;  /* m  as added; as of the last dem_wall_move, or NULL */
};

/* a patch of the mesh, of all ranks */
struct dem_flow_patch
{
    char name[64];
    size_t n;
    double *triangles;  /* n times 9 coordinates [m] and 3 of the fluid's velocity [m/s] */
};

struct dem
{
    struct dem_state state;
    struct dem_attached_stores stores;                    /* to which the state has pointers */
    struct dem_scene scene;
    struct dem_dict *dict;
    struct dem_initial_particles initial;                 /* of dem_add_particles; materials are
                                                             looked up in setup */
    char (*initial_material)[48];
    size_t initial_capacity;
    struct dem_mesh_wall *mesh_wall;
    size_t mesh_walls, mesh_wall_capacity;
    struct dem_flow_patch *patch;
    size_t patches, patch_capacity;
    struct dem_outgoing_particle *outgoing;               /* particles that the program takes out
                                                             next */
    size_t outgoing_count, outgoing_capacity;
    int flow_on_request;                                  /* 1: streams and outlets act between
                                                             advances only */
    char load_path[1024];
    int checked;                                          /* 1: dem_check succeeded, -1: it
                                                             failed */
    int is_set_up, with_fluid, coupled;
    int scene_start;                                      /* 1: load_path is the scene's entry
                                                             `start`: time begins at 0 */
    int start_checked;                                    /* 1: its overlap with the walls is
                                                             checked (dem_start) */
    int restored;                                         /* 1: dem_restore was called; averages
                                                             hold later samples */
    int failed;                                           /* 1: the last dem_advance has failed */
    int ranks_apart;                                      /* 1: the last dem_advance did not fail on
                                                             all ranks together */
    int energy;                                           /* 1: the energy balance was asked for */
    int orientation;                                      /* 1: orientations were asked for */
    int virial;                                           /* 1: dem_virial will be called */
    int exchanges;                                        /* calls of dem_scalar_exchange_enable, */
    char exchanged[DEM_SCALARS][48];                      /* and their scalars */
    int driven;                                           /* 1: there are driven particles */
    int pressure_gradient;                                /* 1: pressureGradient is among the
                                                             effects */
    const struct dem_effect *fluid_user;                  /* an effect that needs the fluid of the
                                                             run; NULL: none */
    double displaced_density;                             /* kg/m3  dem_fluid_set_displaced */
    double fluid_density;                                 /* kg/m3  dem_fluid_set_density */
    struct dem_overlap start_pair, start_wall;            /* largest ones at a start that is
                                                             checked */
    struct dem_snapshot_scene before;                     /* of the loaded snapshot (case/restart.h) */
    char (*reformed)[64];                                 /* its walls whose form the scene has
                                                             changed */
    size_t reformed_walls, reformed_capacity;
    char **note;                                          /* sentences on its differences */
    size_t notes, note_capacity;
    int inserts;                                          /* 1: groups are new at this restart */
    int program_particles;                                /* 1: dem_add_particles was called */
    int64_t next_id;                                      /* the first id that no particle has had,
                                                             streams apart */
    struct dem_skins snapshot_skins;                      /* skins of the neighbor lists in the
                                                             loaded snapshot */
    struct dem_snapshot snapshot_flows;                   /* its streams and outlets */
    struct dem_flow flow[DEM_SNAPSHOT_FLOWS];             /* as returned last by dem_flows */
    double step;                                          /* s  the longest step that dem_advance
                                                             takes */
    struct dem_text plan, profile, warnings, impact, effect, value_text;  /* the texts returned last */
    double said_overlap, said_speed;                      /* 1, m/s  at the last dem_impact_warning
                                                             with a sentence */
    struct dem_verdicts *verdicts;                        /* of that plan; NULL: none yet */
    char heading[DEM_HEADING + 800], fluid_effects[400];  /* "effects: " and all names; names of
                                                             fluid effects */
};

/* DEM_ERROR_STATE, with the name of the call, when it comes after dem_check or dem_setup. */
int dem_api_require_unchecked(const struct dem *, const char *call);

/* DEM_ERROR_STATE, with the name of the call, after a dem_advance that failed. */
int dem_api_require_sound(const struct dem *, const char *call);

/* An error when n, the number of `items` given in a call, is below 0 or above what memory can hold. */
int dem_api_require_count(const char *call, const char *items, int64_t n);

/* Collective. All ranks fail when one does: a rank without an error of its own reports that
   another one failed. */
int dem_api_agree(const struct dem *, int status);

/* Collective. Concatenate n items of `size` doubles from each rank, in the order of the ranks. A rank
   that has failed before, with this status, takes part, and all ranks fail.
   *items belongs to the caller (dem_memory_free) and is set only on success; NULL without items. */
int dem_api_gather(const struct dem_state *, int status, size_t size, size_t n, const double *mine,
                   double **items, size_t *number);

/* Give the triangles of the patches, of one or of all, to the streams that enter through them. */
int dem_api_give_patch(struct dem *, const struct dem_flow_patch *);
int dem_api_assign_patches(struct dem *);

/* Collective. Set where the triangles of a wall will be at the end of the next advance; with
   `now`, where they are. */
int dem_api_move_wall(struct dem *, const struct dem_mesh_wall *, int now);

/* Before walls are read: on which ranks triangles are given. */
void dem_api_begin_walls(struct dem *);

/* Collective. Add the walls of dem_add_wall to those of the scene; move those for which
   dem_wall_move was called. */
int dem_api_add_mesh_walls(struct dem *);
int dem_api_position_mesh_walls(struct dem *);

/* Collective. Create the particles, on each rank a part of them; reduce their radii by material
   over all ranks into the interaction table; fill the fluid columns; start streams and outlets. */
int dem_api_create_particles(struct dem *);
int dem_api_find_radii(struct dem_state *);
int dem_api_add_radii(struct dem *);              /* of groups, streams and dem_add_particles */
int dem_api_store_initial(struct dem *, size_t from);    /* initial particles, from number `from` on */
int dem_api_join_initial(struct dem *);
void dem_api_init_fluid(struct dem *);
int dem_api_begin_flows(struct dem *);

/* DEM_ERROR_INPUT when a value of the fluid that the effects read (fluid_entry) is not given at a
   particle of this rank. */
int dem_api_require_fluid_scalars(const struct dem *);

/* Checks that need no particles, of a scene that has been read and whose walls exist. */
int dem_api_check_scene(struct dem *);

/* Collective. Once all radii are known: freeze the interaction table, choose the time step, finish the
   walls. */
int dem_api_finish_physics(struct dem *);
double dem_api_max_radius(const struct dem *);    /* m  0 without particles */

/* Collective. Read the scene and check it, without particles. */
int dem_api_read_scene(struct dem *);

/* Collective. Create the particles, distribute them to their owners, build the first lists. */
int dem_api_setup(struct dem *);

#endif
