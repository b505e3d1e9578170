/*
 * initial_particles.h -- particles of the start, before they are sent to the ranks that own their
 * positions.
 *
 * Each rank has a part of them; the summaries of the groups are of all ranks and known to all.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/interaction_table.h"
#include "particles/clump.h"
#include "particles/particles.h"

/* summary of one group of the scene, for the plan */
struct dem_group_summary
{
    char name[48];
    int material;                            /* -1: several */
    int64_t n;
    double min_diameter, max_diameter, sum;  /* m  smallest, largest and sum of diameters */
    double volume, mass;                     /* m3, kg */
};

/* radii; the largest distance from the origin at the start: positions are rounded to 1e-6 radii
   there, a hundredth of a small overlap */
static const double dem_max_distance = 1e10;

struct dem_initial_particles
{
    size_t n, capacity;
    struct dem_particle *particle;
    int scalars;                  /* values per particle in the next array, from the table */
    double *scalar, default_scalar[DEM_SCALARS];
    size_t scalar_capacity;
    int has_clumps;               /* 1: there are shapes; the body of each particle: */
    struct dem_clump *clump;
    size_t clump_capacity;
    int64_t next_id;
    size_t groups, group_capacity;
    struct dem_group_summary *group;
};

void dem_initial_particles_free(struct dem_initial_particles *);

/* Before the first particle: they have the scalars of this table, with default values. */
void dem_initial_particles_have_scalars(struct dem_initial_particles *,
                                        const struct dem_interaction_table *);

/* The scalars of the particle added last. */
static inline double *dem_initial_particles_last_scalars(struct dem_initial_particles *c)
{
    return c->scalar + (c->n - 1)*(size_t)c->scalars;
}

/* Begin the summary of a group; add n equal spheres (diameter [m], solid volume [m3] and mass [kg] of
   each) to it.
   Called on each rank for the particles of all ranks. */
int dem_initial_particles_begin_group(struct dem_initial_particles *, const char *group);
void dem_initial_particles_count(struct dem_initial_particles *, int64_t n, double diameter,
                                 double volume, double mass, int material);

/* An error for a spin [1/s] at which the surface of a sphere moves faster than light. */
int dem_initial_particles_check_spin(const char *where, const double w[3], double radius);

/* Add a particle; id < 0 takes the next free id. An error for numbers that are not finite or out
   of range; `where` starts the message. */
int dem_initial_particles_add(struct dem_initial_particles *, struct dem_particle,
                              const char *where);

/* Free the particles, once they have been copied into the particle arrays; the summaries stay. */
void dem_initial_particles_release(struct dem_initial_particles *);
