/*
 * pairs.h -- finding pairs: the cell grid, the order of particles, the two skins and when each list is stale.
 *
 * Skins begin where the effects end: at the reach of the one that reaches furthest past touching. Outer pairs are found
 * when some particle has moved more than half of the outer skin since the last time, near rows pruned when it has moved
 * more than half of the inner skin. The running sum of the largest speed times dt is a cheap
 * bound; only when it runs out are displacements looked at. So no contact is ever missed, however fast a particle is.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_SPACE_PAIRS_H
#define DEM_SPACE_PAIRS_H

#include "space/domain.h"
#include "space/wall_search.h"
#include "state/contacts.h"
#include <stdalign.h>

struct dem_pairs
{
    double outer, inner;                                  /* m: gaps up to which pairs are listed, and rows kept */
    double half_outer, half_inner;                        /* m: half of the skins; who moves further makes the lists stale */
    double most_radius;                                   /* m: of all particles of all ranks */
    alignas(16) double shift[DEM_SHIFTS][4];               /* m, m, m, 0; read four at once */
    struct dem_wall_search search;
    int *wall_region;                                     /* region of each wall near */
    size_t wall_region_room;

    double moved_outer, moved_inner;                      /* m: bounds since the last rebuild and prune */
    double *at_outer, *at_inner;                          /* m: positions then, 3 an owned particle */
    size_t at_room;

    size_t near_room;
    uint8_t *near;
};

/* `skin` [m]: outer, inner; `reach` [m]: past touching, of all effects. */
void dem_pairs_init(struct dem_pairs *, const struct dem_domain *, const double skin[2], double reach, double most_radius);
void dem_pairs_free(struct dem_pairs *);

/* Bytes held. */
size_t dem_pairs_bytes(const struct dem_pairs *);

/* Sort owned particles by (cell, id): the one global order. Drops ghosts. */
int dem_pairs_order(struct dem_pairs *, struct dem_particles *);

/* Find all outer pairs of owned particles with owned ones, copies and walls, sorted by class. */
int dem_pairs_find(struct dem_pairs *, const struct dem_domain *, const struct dem_particles *, const struct dem_walls *,
                   const struct dem_recipe *, struct dem_contacts *);

/* Parts of the above: refuse more particles (with copies) or pairs on a rank than the 32 bits of an index tell apart; where
   particles are now. */
int dem_pairs_countable(size_t particles, size_t pairs);
int dem_pairs_remember(struct dem_pairs *, const struct dem_particles *);

/* Prune near rows from the outer pairs at the present positions. */
int dem_pairs_prune(struct dem_pairs *, const struct dem_particles *, const struct dem_walls *, struct dem_contacts *);

/* Largest displacement [m] of owned particles since the last rebuild and the last prune. */
void dem_pairs_moved(const struct dem_pairs *, const struct dem_particles *, double *outer, double *inner);

#endif
