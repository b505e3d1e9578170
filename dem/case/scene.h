/*
 * scene.h -- reader of scenes: materials, effects, walls, domain, particles and parameters of the
 * run.
 *
 *     materials { NAME { density; youngsModulus; poissonsRatio; } }
 *     effects   { WORD { SETTING VALUE; } }                    physical models, for all contacts
 *     pairs     { NAME { between (A B); WORD { SETTING VALUE; } } }
 *                                                              other settings for two materials
 *     walls     { NAME { type plane|box|cylinder|sphere|triangles|stl|patch|surface;
 *                        material; motion { ... } ... } }
 *     domain    { min; max; | x; y; z; periodic (x y z); flat (x y z); leaving error|remove;
 *                 cell { xx { rate; | stress; start; end; } yy; zz; xy { rate; } maxRate; } }
 *     insert    { NAME { type lattice|random|list|table|stream; ... } }
 *     shapes    { NAME { spheres ((x y z r) ...); } }          rigid bodies of several spheres
 *     outlets   { NAME { min; max; | cylinder; | sphere; | point; normal; | patch; } }
 *     planes    { NAME { point; normal; radius; } }            count what passes
 *     start     { snapshot "FILE"; SCALAR VALUE; }             instead of insert
 *     bonds     { pairs (ID ID ...); }                         for an effect with listed bonds
 *     fluid     { velocity; density; viscosity; voidFraction; pressureGradient; }
 *                                                              uniform, without a coupled solver
 *     time      { end; step auto|NUMBER; maxOverlap; maxSpeed; force; }
 *     stages    { NAME { until quiet; | until { force WALL; value; } | duration; atMost; } }
 *     neighbours{ outerSkin; innerSkin; }
 *     averages  { NAME { min; max; cells; start; end; interval; } }
 *     device    gpu|NAME;                                      makes the steps in place of the CPU
 *     write     { ... }                                        read by the program
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/uniform_fluid.h"
#include "case/scene_cell.h"
#include "case/stages.h"
#include "records/averages_io.h"
#include "input/dictionary.h"
#include "sources/insert.h"
#include "sources/stream.h"
#include "particles/domain.h"
#include "particles/applied_forces.h"
#include "particles/clump_shape.h"
#include "laws/interaction_table.h"
#include "particles/scalar_entry.h"
#include "walls/walls.h"

struct dem_scene
{
    double step;                           /* s; 0: automatic */
    bool force;                            /* accept a time step above the limit */
    double max_overlap;                    /* 1  of a diameter */
    double max_start_overlap;              /* 1  of a diameter, at the start */
    double max_speed;                      /* m/s  0: no limit */
    double outer_skin, inner_skin;         /* 1  of the largest diameter */
    int tuned_skins;                       /* 1: tune them, the scene gives none */
    const char *snapshot;                  /* path to start from, or NULL */
    struct dem_scalar_entry start_scalar[DEM_SCALARS];    /* of its particles, where given */
    int start_frozen;                      /* 1: freeze them, 0: free them, -1: as they are */
    struct dem_uniform_fluid fluid;
    struct dem_clump_shapes shapes;        /* templates of rigid bodies */
    struct dem_insertion insertion;        /* groups of particles to be placed */
    struct dem_streams streams;            /* streams and outlets */
    struct dem_initial_particles initial;  /* particles of all groups, once placed */
    struct dem_averages_entry *average;    /* grids of time averages */
    int averages;
    const char *device;                    /* that makes the steps; "cpu": none */
    const int64_t *bond_ids;               /* ids of bonded pairs, two each; NULL: no list */
    size_t bond_id_count;
    struct dem_run_stages stages;
    struct dem_cell cell;
};

/* Read the materials; call this first, because walls and particles added through the API need
   them. */
int dem_scene_read_materials(const struct dem_dict *, struct dem_interaction_table *);

/* Read all other entries that the core needs; `write` and time/end are left to the program.
   Strings and lists of the scene belong to the dictionary, which must outlive it.
   DEM_ERROR_INPUT with file, line and cure. */
int dem_scene_read(struct dem_scene *, const struct dem_dict *, struct dem_interaction_table *,
                   struct dem_walls *, struct dem_domain *);
void dem_scene_free(struct dem_scene *);

/* The entry forces. Materials must have been read. */
int dem_scene_read_forces(const struct dem_dict *, const struct dem_interaction_table *,
                          struct dem_applied_forces *);
