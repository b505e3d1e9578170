/*
 * pairs.h -- neighbor lists with two skins: order of particles, search for pairs, pruning,
 * validity.
 *
 * Skins begin at the largest reach of all effects past touching. Pairs are searched again when two
 * particles, or a particle and a wall, may have approached each other by more than the outer skin
 * since the last search (displacement.h); contact rows are pruned from them when it may be more
 * than the inner skin. The accumulated largest speed times dt is a cheap bound of the displacement;
 * only when it is exceeded are displacements evaluated. So no contact is ever missed, however fast
 * a particle is.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/domain.h"
#include "contacts/displacement.h"
#include "contacts/grid.h"
#include "contacts/skins.h"
#include "walls/wall_search.h"
#include "contacts/contacts.h"
#include <stdalign.h>

struct dem_pairs
{
    double reach;                             /* m: past touching, of all effects */
    double outer, inner;                      /* m: limits of the gap of pairs and of rows */
    double half_outer, half_inner;            /* m: half of the skins */
    struct dem_skins skins;
    struct dem_displacement displacement[DEM_LISTS];
    double max_radius;                        /* m: of all particles of all ranks */
    alignas(16) double shift[DEM_SHIFTS][4];  /* m, m, m, 0; read four at once */
    struct dem_grid grid;                     /* of the last dem_pairs_search */
    struct dem_wall_search wall_search;
    struct dem_facet_key *wall_facet;         /* facet of each wall neighbor */
    size_t wall_facet_capacity;
};

/* skin [m]: outer, inner; reach [m]: past touching, of all effects; max_radius [m]: largest of all
   ranks. */
void dem_pairs_init(struct dem_pairs *, const struct dem_domain *, const double skin[2],
                    double reach, double max_radius);
void dem_pairs_free(struct dem_pairs *);

/* Change the reach [m] and the largest radius [m]. */
void dem_pairs_set_reach(struct dem_pairs *, double reach, double max_radius);

/* Tune the skins between 1e-3 `max` and `max` [m], beginning with the present ones. */
void dem_pairs_tune(struct dem_pairs *, double max);

/* Before ghosts are built and pairs are searched: use the outer skin that was chosen last. */
void dem_pairs_use_chosen_skin(struct dem_pairs *);

/* Bytes held. */
size_t dem_pairs_bytes(const struct dem_pairs *);

/* Sort owned particles by (cell, id). Removes ghosts. */
int dem_pairs_order(struct dem_pairs *, struct dem_particles *);

/* Find all pairs of owned particles with owned ones, ghosts and walls; sorted by class, and within
   a class by the partner that comes first in memory. */
int dem_pairs_find(struct dem_pairs *, const struct dem_domain *, const struct dem_particles *,
                   const struct dem_walls *, const struct dem_interaction_table *,
                   struct dem_contacts *);

/* The first part of the above: pairs of particles, in no order. Keeps the grid for the next search. */
int dem_pairs_search(struct dem_pairs *, const struct dem_domain *, const struct dem_particles *,
                     const struct dem_interaction_table *, struct dem_contacts *);

/* Index, among those held, of the facet of a wall neighbor. */
static inline int dem_pairs_facet(const struct dem_pairs *s, uint32_t wall_neighbor)
{
    return s->wall_search.neighbor[wall_neighbor].facet;
}

/* Part of both: DEM_ERROR_INPUT for more particles (with ghosts) or pairs on a rank than
   indices of 32 bits allow. */
int dem_pairs_check_counts(size_t particles, size_t pairs);

/* Select the candidate contacts among the pairs at the present positions; they get contact rows. */
int dem_pairs_prune(struct dem_pairs *, const struct dem_particles *, const struct dem_walls *,
                    struct dem_contacts *);
