/*
 * insert.h -- initial particles of the scene's `insert`: on a lattice, at random without overlap,
 * from a list or a table.
 *
 * 1. Every rank reads and checks all groups.
 * 2. Each rank places a part of each group.
 *
 * A position is a function of the seed and the particle's number, so it does not depend on the rank
 * that computes it. Random packings are also independent of the number of ranks (packing.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/clump_shape.h"
#include "particles/initial_particles.h"
#include "sources/insertion_limits.h"
#include "input/dictionary.h"
#include "particles/domain.h"
#include "ranks/decomposition.h"
#include "laws/interaction_table.h"

/* all groups of a scene */
struct dem_insertion
{
    size_t n, capacity;
    struct dem_insert_group *group;
    struct dem_insertion_regions regions;  /* to which groups point; before they are read */
    const struct dem_domain *domain;       /* likewise */
    const struct dem_clump_shapes *shapes; /* likewise */
};

/* 1 when a group of `insert` comes in during the run (sources/stream.h). */
int dem_insert_is_stream(const struct dem_dict *group);

/* Read and check every group of a scene's `insert { ... }`. The dictionary must outlive the
   groups, which point into it. Streams (stream.h) are skipped. */
int dem_insert_read(struct dem_insertion *, const struct dem_dict *insert,
                    const struct dem_interaction_table *, const struct dem_walls *);
void dem_insert_free(struct dem_insertion *);

/* The name of group k; leave it out, before particles are placed. */
const char *dem_insert_name(const struct dem_insertion *, size_t k);
void dem_insert_drop(struct dem_insertion *, size_t k);

/* Extend the ranges of radii [m], one a material, by the groups' radii; 0 means none yet. Likewise the
   smallest volume of clumps for the limit of the time step [m3]. */
void dem_insert_radii(const struct dem_insertion *, double *min, double *max, double *body);

/* Extend the range of ratios of parcels by the groups' ratios. */
void dem_insert_ratios(const struct dem_insertion *, struct dem_interaction_table *);

/* The first id above the ids of all groups. Refuse an id that occurs twice, in the groups or among
   these n others. */
int64_t dem_insert_next_id(const struct dem_insertion *);
int dem_insert_refuse_duplicates(const struct dem_insertion *, size_t n, const int64_t *id);

/* Refuse groups outside the domain, by the ends of the rows and layers of a lattice and the bounding
   box of a random group; other particles outside are refused when they are placed. */
int dem_insert_check_domain(const struct dem_insertion *, const struct dem_domain *);

/* Collective. Create the particles of all groups, each rank a part of them. Fails on all ranks
   when it does on one. The number of a lattice with limits becomes the number of sites taken. */
int dem_insert_place(struct dem_initial_particles *, struct dem_insertion *,
                     const struct dem_interaction_table *, const struct dem_walls *,
                     const struct dem_decomposition *);
