/*
 * dem_case.h -- struct dem_case: the run that is being set up, and data that only the set-up needs.
 *
 * The files of case/ take the case; the folders above see struct dem only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "case/simulation.h"

struct dem_case
{
    struct dem *d;                              /* what will run */
    int checked;                                /* 1: dem_case_check succeeded, -1: it failed */

    /* particles of the program; their materials are looked up when they are placed */
    struct dem_initial_particles initial;
    char (*initial_material)[48];
    size_t initial_capacity;

    /* of what only some runs need */
    int energy, orientation, virial;            /* 1: asked for */
    int exchanges;                              /* calls of dem_case_exchange_scalar, */
    char exchanged[DEM_SCALARS][48];            /* and their scalars */
    double displaced_density, fluid_density;    /* kg/m3  of the coupled fluid */
    int own_wake;                               /* dem_case_fluid_own_wake */
    struct dem_allowed_diameters                /* dem_case_allow_diameters */
    {
        char material[48];
        double min, max;                        /* m */
    } *allowed;
    size_t alloweds, allowed_capacity;

    double start_time;                          /* s  dem_case_start_time */

    /* a snapshot */
    char load_path[1024];                       /* "": none */
    int new_run;                                /* 1: its particles are for another run */
    int scene_start;                            /* 1: it is the scene's entry `start`: time begins
                                                   at 0 */
    struct dem_skins snapshot_skins;            /* of its neighbor lists */
    struct dem_snapshot snapshot_flows;         /* its streams and outlets */
    char (*reformed)[64];                       /* its walls whose form the scene has changed */
    size_t reformed_walls, reformed_capacity;
    int inserts;                                /* 1: groups are new at this restart */
};

/* Collective. Give the triangles of all patches to the streams. */
int dem_sim_assign_patches(struct dem *);

/* Before walls are read: on which ranks triangles are given. */
void dem_sim_begin_walls(struct dem *);

/* Collective. Add the walls of dem_case_add_wall to the walls of the scene; move each to its present
   position. */
int dem_sim_add_mesh_walls(struct dem *);
int dem_sim_position_mesh_walls(struct dem *);

/* Collective, when the walls have been read: masses of free walls that are solids, and their spins. */
int dem_sim_begin_bodies(struct dem *);

/* Collective. Read the scene and check it, without particles. */
int dem_sim_read_scene(struct dem_case *);

/* Checks that need no particles, of a scene that has been read and whose walls exist. */
int dem_sim_check_scene(struct dem_case *);

/* Refuse what does not work with rigid bodies of several spheres, and set interaction_table.bond_radius; once the
   particles are known, how far the bodies reach out of subdomains (collective). */
int dem_sim_check_clumps(struct dem_case *);
int dem_sim_begin_clumps(struct dem *);

/* Collective. Once all radii are known: freeze the interaction table, choose the time step, finish
   the walls. */
int dem_sim_finish_physics(struct dem *);

/* Collective. Create the particles, on each rank a part of them; reduce their radii by material
   over all ranks into the interaction table; fill the fluid columns; start streams and outlets. */
int dem_sim_create_particles(struct dem_case *);
int dem_sim_find_radii(struct dem *);
int dem_sim_add_radii(struct dem_case *);       /* of groups, streams and the program */
int dem_sim_store_initial(struct dem *, size_t from);    /* initial particles, from number `from` on */
int dem_sim_join_initial(struct dem_case *);
void dem_sim_init_fluid(struct dem *);
int dem_sim_begin_flows(struct dem_case *);

/* Refuse overlaps at the start: of all particles, with the lists of the first step; of those from
   the state of another run with walls; of those inserted at a restart. */
int dem_sim_refuse_overlap(struct dem *);
int dem_sim_check_start(struct dem_case *);
int dem_sim_check_inserted(struct dem_case *);

/* With lists: refuse an overlap of a particle that is flagged as new. */
int dem_sim_refuse_new_overlap(struct dem *);

/* Call `look` with the lists built from the state of a snapshot, on a backup; then everything is
   put back, so that the run goes on with the same bits; also after an error of `look`. */
int dem_sim_with_lists(struct dem *, int (*look)(struct dem *));
