/*
 * packing.h -- random packing of spheres in an insertion shape, without overlap, also with the
 * spheres of earlier groups and with periodic images.
 *
 * 1. Random sequential addition, largest spheres first (packing_addition.c). It ends near a solid
 *    fraction of 0.3; a sphere that finds no free position stays at its last trial.
 * 2. Relaxation: overlapping spheres move apart, all at once, until no overlap is left
 *    (packing_relax.c), up to 0.57.
 *
 * Spheres are particles, on the rank that owns their position, with ghosts, periodic images and
 * neighbor lists like the particles of a run. The result is a function of the seed and the
 * diameters, the same to the last bit on any number of ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/initial_particles.h"
#include "sources/insertion_limits.h"
#include "sources/insertion_shape.h"
#include "contacts/pairs.h"
#include "ranks/halo.h"

/* the spheres to pack, and where */
struct dem_packing
{
    const struct dem_insertion_shape *shape;
    const struct dem_domain *domain;  /* spheres overlap no periodic image either */
    const char *where;        /* starts messages */
    uint64_t seed;
    int64_t n;                /* spheres of all ranks */
    double diameter;          /* m  of all, unless there are diameters */
    const double *diameters;  /* m  of each, or NULL */
};

/* An error when n spheres of this total volume [m3] are denser than a random packing can be.
   `of` names the spheres, `where` starts the message. */
int dem_packing_check_fraction(const struct dem_insertion_shape *, double volume, double n,
                               const char *of, const char *where);

/* the spheres of a packing; ids of particles: numbers in the group, below 0 for spheres of earlier
   groups, which are frozen */
struct dem_packing_spheres
{
    struct dem_decomposition decomposition;
    struct dem_halo halo;
    struct dem_particles particles;
    struct dem_pairs search;
    struct dem_interaction_table table;  /* all zero: one class of pairs */
    struct dem_contacts contacts;        /* only its pair list is used */
    double max_radius;                   /* m  of all ranks */
};

int dem_packing_spheres_init(struct dem_packing_spheres *, const struct dem_domain *,
                             const struct dem_decomposition *of);
void dem_packing_spheres_free(struct dem_packing_spheres *);

/* Collective. Pack spheres for which dem_packing_check_fraction succeeds, each no wider than the
   shape, around the particles of earlier groups, which do not move. The results are the owned
   particles of this rank, in no order. */
int dem_packing_fill(const struct dem_packing *, const struct dem_initial_particles *,
                     struct dem_packing_spheres *);

enum
{
    DEM_PACKING_LIMITED_DRAWS = 100000  /* points for one trial where walls or a mesh leave an unknown
                                           part of the shape */
};

/* ---- steps of dem_packing_fill --------------------------------------------------------------- */

/* Set the position of a sphere to its `trial`-th trial, wrapped into the domain. Returns 0
   when the limits of the shape leave none. */
int dem_packing_draw(const struct dem_packing *, struct dem_particle *, uint64_t trial);

/* Collective. Wrap spheres, send them to the owners of their positions, make ghosts, and list the
   pairs with a gap below `gap` [m] in contacts.pairs. `status`: of this rank; one that has failed takes part,
   and all ranks return an error. */
int dem_packing_list_pairs(const struct dem_packing *, struct dem_packing_spheres *, int status,
                           double gap);

/* Collective. Place all new spheres at random; *left is the number of those that overlap. */
int dem_packing_place(const struct dem_packing *, struct dem_packing_spheres *, int64_t *left);

/* Collective. Move spheres apart until no overlap is left. `mean_diameter` [m] sets the skin of
   the pair list. */
int dem_packing_relax(const struct dem_packing *, struct dem_packing_spheres *,
                      double mean_diameter);
