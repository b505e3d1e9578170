/*
 * scene.h -- the words of a scene become materials, effects, walls, a domain, particles and numbers for the run.
 *
 *     materials { NAME { density; youngsModulus; poissonsRatio; } }
 *     effects   { WORD { SETTING VALUE; } }                      what acts, with the numbers for all contacts
 *     pairs     { NAME { between (A B); WORD { SETTING VALUE; } } }   other numbers for two materials
 *     walls     { NAME { type plane|box|cylinder|sphere|triangles|stl|patch|surface; material; motion { ... } ... } }
 *     domain    { min; max; | x; y; z; periodic (x y z); flat (x y z); leaving error|remove; }
 *     insert    { NAME { type lattice|random|list|table|stream; ... } }
 *     outlets   { NAME { min; max; | cylinder; | sphere; | point; normal; | patch; } }
 *     start     { snapshot "FILE"; }                             instead of insert
 *     fluid     { velocity; density; viscosity; voidFraction; pressureGradient; }   uniform, when none is coupled
 *     time      { end; step auto|NUMBER; maxOverlap; maxSpeed; force; precision; }
 *     neighbours{ outerSkin; innerSkin; }
 *     averages  { NAME { min; max; cells; start; end; interval; } }
 *     write     { ... }                                          read by the program
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_SCENE_H
#define DEM_IO_SCENE_H

#include "io/averages.h"
#include "io/dictionary.h"
#include "io/insert.h"
#include "io/stream.h"
#include "space/domain.h"
#include "state/recipe.h"
#include "state/walls.h"

struct dem_uniform_fluid
{
    int given;
    double velocity[3], density, viscosity, void_fraction, pressure_gradient[3];   /* m/s, kg/m3, Pa s, 1, Pa/m */
    double acceleration[3], vorticity[3], stress[3];      /* m/s2, 1/s, N/m3: Du/Dt, curl u, div tau */
};

struct dem_scene
{
    double step;                                          /* s; 0: automatic */
    bool force;                                           /* take a step over the limit all the same */
    double most_overlap;                                  /* 1  of a diameter */
    double most_speed;                                    /* m/s  0: any */
    double outer_skin, inner_skin;                        /* 1  of the largest diameter */
    int tuned_skins;                                      /* 1: the scene gives none */
    const char *snapshot;                                 /* path to start from, or NULL */
    struct dem_uniform_fluid fluid;
    struct dem_insertion insertion;                       /* groups of the text, to be placed */
    struct dem_streams streams;                           /* what comes in and goes out on the way */
    struct dem_crowd crowd;                               /* all particles of the start, when they have been */
    struct dem_average_plan *average;                     /* grids of means */
    int averages;
    const int64_t *bond_ids;                              /* two a pair that the scene wants bonded; NULL: no list */
    size_t bond_id_count;
};

/* The materials first: walls and particles that are handed in by program need them. */
int dem_scene_read_materials(const struct dem_dict *, struct dem_recipe *);

/* Read all else that the core needs; the entries of `write` and time/end are left to the program. */
int dem_scene_read(struct dem_scene *, const struct dem_dict *, struct dem_recipe *, struct dem_walls *, struct dem_domain *);
void dem_scene_free(struct dem_scene *);

#endif
