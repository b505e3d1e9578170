/*
 * insert.h -- particles from words: on a lattice with jitter, at random without overlap, or one by one.
 *
 * All of them are functions of the seed and the particle's number alone, so every rank makes the same list.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_INSERT_H
#define DEM_IO_INSERT_H

#include "io/dictionary.h"
#include "state/particles.h"
#include "state/recipe.h"

struct dem_crowd                                          /* particles before they are handed to ranks */
{
    size_t n, room;
    struct dem_particle *particle;
    int64_t next_id;
};

void dem_crowd_free(struct dem_crowd *);

/* Add one; id < 0 takes the next free number. Refuses what is not a sphere. `where` starts messages. */
int dem_crowd_add(struct dem_crowd *, struct dem_particle, const char *where);

/* Read every group of a scene's `insert { ... }`. */
int dem_insert_read(struct dem_crowd *, const struct dem_dict *insert, const struct dem_recipe *);

#endif
