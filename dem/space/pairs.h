/*
 * pairs.h -- finding pairs: the order of particles, the two skins and when each list is stale.
 *
 * Skins begin where the effects end: at the reach of the one that reaches furthest past touching. Outer pairs are found
 * anew when two particles, or one and a wall, may have come nearer to each other by more than the outer skin since the last time
 * (drift.h), near rows pruned when it may be more than the inner skin. The running sum of the largest speed times dt is a cheap
 * bound; only when it runs out are displacements looked at. So no contact is ever missed, however fast a particle is.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_SPACE_PAIRS_H
#define DEM_SPACE_PAIRS_H

#include "space/domain.h"
#include "space/drift.h"
#include "space/skins.h"
#include "space/wall_search.h"
#include "state/contacts.h"
#include <stdalign.h>

struct dem_pairs
{
    double reach;                                         /* m: past touching, of all effects */
    double outer, inner;                                  /* m: gaps up to which pairs are listed, and rows kept */
    double half_outer, half_inner;                        /* m: half of the skins */
    struct dem_skins skins;
    struct dem_drift drift[DEM_LISTS];
    double most_radius;                                   /* m: of all particles of all ranks */
    alignas(16) double shift[DEM_SHIFTS][4];               /* m, m, m, 0; read four at once */
    struct dem_wall_search search;
    int *wall_region;                                     /* region of each wall near */
    size_t wall_region_room;
};

/* `skin` [m]: outer, inner; `reach` [m]: past touching, of all effects. */
void dem_pairs_init(struct dem_pairs *, const struct dem_domain *, const double skin[2], double reach, double most_radius);
void dem_pairs_free(struct dem_pairs *);

/* Let skins [m] be tuned up to `most`; they begin as they are. */
void dem_pairs_tune(struct dem_pairs *, double most);

/* Before copies are taken and pairs are found: the outer skin that was chosen last. */
void dem_pairs_thicken(struct dem_pairs *);

/* Bytes held. */
size_t dem_pairs_bytes(const struct dem_pairs *);

/* Sort owned particles by (cell, id): the one global order. Drops ghosts. */
int dem_pairs_order(struct dem_pairs *, struct dem_particles *);

/* Find all outer pairs of owned particles with owned ones, copies and walls, sorted by class and within one by who comes first in memory. */
int dem_pairs_find(struct dem_pairs *, const struct dem_domain *, const struct dem_particles *, const struct dem_walls *,
                   const struct dem_recipe *, struct dem_contacts *);

/* Part of the above: refuse more particles (with copies) or pairs on a rank than the 32 bits of an index tell apart. */
int dem_pairs_countable(size_t particles, size_t pairs);

/* Prune near rows from the outer pairs at the present positions. */
int dem_pairs_prune(struct dem_pairs *, const struct dem_particles *, const struct dem_walls *, struct dem_contacts *);

#endif
