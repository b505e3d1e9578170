/*
 * simulation.h -- struct dem, a simulation, and the functions that the files of case/ and run/ share.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_query.h"
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

/* a wall of dem_case_add_wall: the triangles of this rank */
struct dem_mesh_wall
{
    char name[64], material[48];
    size_t n;
    double *triangles, *moved;  /* m  as added; as of the last movement, or NULL */
};

/* a patch of the mesh, of all ranks */
struct dem_flow_patch
{
    char name[64];
    size_t n;
    double *triangles;  /* n times 9 coordinates [m] and 3 of the fluid's velocity [m/s] */
};

/* what a run needs, from the set-up on; before, it belongs to struct dem_case (case/dem_case.h) */
struct dem
{
    struct dem_state state;
    struct dem_attached_stores stores;                    /* to which the state has pointers */
    struct dem_scene scene;
    struct dem_dict *dict;                                /* of the scene, which has pointers into it */
    struct dem_mesh_wall *mesh_wall;
    size_t mesh_walls, mesh_wall_capacity;
    struct dem_flow_patch *patch;
    size_t patches, patch_capacity;
    struct dem_outgoing_particle *outgoing;               /* particles that the program takes out
                                                             next */
    size_t outgoing_count, outgoing_capacity;
    int flow_on_request;                                  /* 1: streams and outlets act between
                                                             advances only */
    int with_fluid, coupled;
    int restored;                                         /* 1: dem_restore was called; averages
                                                             hold later samples */
    int failed;                                           /* 1: the last dem_advance has failed */
    int ranks_apart;                                      /* 1: the last dem_advance did not fail on
                                                             all ranks together */
    int driven;                                           /* 1: there are driven particles */
    int pressure_gradient;                                /* 1: pressureGradient is among the
                                                             effects */
    const struct dem_effect *fluid_user;                  /* an effect that needs the fluid of the
                                                             run; NULL: none */
    struct dem_overlap start_pair, start_wall;            /* largest ones at a start that is
                                                             checked, */
    const char *start_walls;                              /* of walls with 1 here; NULL: of all */
    struct dem_snapshot_scene before;                     /* of the snapshot that the run continues
                                                             (case/restart.h) */
    char **note;                                          /* sentences on its differences */
    size_t notes, note_capacity;
    int program_particles;                                /* 1: dem_case_add_particles was called */
    int64_t next_id;                                      /* the first id that no particle has had,
                                                             streams apart */
    struct dem_flow flow[DEM_SNAPSHOT_FLOWS];             /* as returned last by dem_flows */
    double step;                                          /* s  the longest step that dem_advance
                                                             takes */
    struct dem_text profile, impact;                      /* the texts returned last */
    char device[1000];                                    /* what makes the steps, or why no device
                                                             does; "": none is asked for */
    double said_overlap, said_speed;                      /* 1, m/s  at the last dem_impact_warning
                                                             with a sentence */
    char heading[DEM_HEADING + 800], fluid_effects[400];  /* "effects: " and all names; names of
                                                             fluid effects */
};

/* DEM_ERROR_STATE, with the name of the call, after a dem_advance that failed. */
int dem_sim_require_sound(const struct dem *, const char *call);

/* An error when n, the number of `items` given in a call, is below 0 or above what memory can hold. */
int dem_sim_require_count(const char *call, const char *items, int64_t n);

/* Collective. All ranks fail when one does: a rank without an error of its own reports that
   another one failed. */
int dem_sim_agree(const struct dem *, int status);

/* Collective. Concatenate n items of `size` doubles from each rank, in the order of the ranks. A rank
   that has failed before, with this status, takes part, and all ranks fail.
   *items belongs to the caller (dem_memory_free) and is set only on success; NULL without items. */
int dem_sim_gather(const struct dem_state *, int status, size_t size, size_t n, const double *mine,
                   double **items, size_t *number);

/* Collective. The triangles and velocities of a patch, of all ranks: the arguments of
   dem_flow_patch. NULL: the call has failed before, with this status. */
int dem_sim_gather_patch(struct dem *, int status, struct dem_flow_patch *, int64_t n,
                         const double *triangles, const double *velocity);
struct dem_flow_patch *dem_sim_find_patch(const struct dem *, const char *name);    /* or NULL */

/* Give the triangles of a patch to the streams that enter through it. */
int dem_sim_give_patch(struct dem *, const struct dem_flow_patch *);

/* Collective. New corners of a wall of the program, for the next advance. */
int dem_sim_copy_corners(struct dem *, const char *call, const char *name, int64_t n,
                         const double *triangles, struct dem_mesh_wall **);

/* Collective. Set where the triangles of a wall will be at the end of the next advance; with
   `now`, where they are. */
int dem_sim_move_wall(struct dem *, const struct dem_mesh_wall *, int now);

/* DEM_ERROR_INPUT when a value of the fluid that the effects read (fluid_entry) is not given at a
   particle of this rank. */
int dem_sim_require_fluid_scalars(const struct dem *);
double dem_sim_max_radius(const struct dem *);    /* m  0 without particles */

/* The scene of the run, for its snapshots; the caller frees it. On the first rank. */
int dem_sim_describe_scene(const struct dem *, struct dem_snapshot_scene *);
