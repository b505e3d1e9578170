/*
 * insert.h -- particles from words: on a lattice with jitter, at random without overlap, one by one, or from a table.
 *
 * First all groups are read and checked, by every rank, then placed, by each a share. Places are functions of the seed and the
 * particle's number alone, so it does not matter who makes them; those at random also see each other (packing.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_INSERT_H
#define DEM_IO_INSERT_H

#include "io/crowd.h"
#include "io/dictionary.h"
#include "space/domain.h"
#include "space/pieces.h"
#include "state/recipe.h"

struct dem_insertion                                      /* all groups of a scene */
{
    size_t n, room;
    struct dem_batch *batch;
};

/* Read and check every group of a scene's `insert { ... }`. The dictionary must outlive it. */
int dem_insert_read(struct dem_insertion *, const struct dem_dict *insert, const struct dem_recipe *);
void dem_insert_free(struct dem_insertion *);

/* Least and most radius [m] that will come, by material; those of none stay. */
void dem_insert_radii(const struct dem_insertion *, double *least, double *most);

/* The first id that is free behind all groups. Refuse an id that comes twice, in groups or among these n others. */
int64_t dem_insert_next_id(const struct dem_insertion *);
int dem_insert_refuse_twins(const struct dem_insertion *, size_t n, const int64_t *id);

/* Refuse what would lie outside the domain. A lattice is looked at where it turns; a rest is refused when it is placed. */
int dem_insert_inside(const struct dem_insertion *, const struct dem_domain *);

/* Collective. Make the particles of all groups, each rank a share of them. Fails on all ranks when it does on one. */
int dem_insert_place(struct dem_crowd *, const struct dem_insertion *, const struct dem_recipe *, const struct dem_pieces *);

#endif
