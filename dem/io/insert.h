/*
 * insert.h -- particles from words: on a lattice with jitter, at random without overlap, or one by one.
 *
 * All of them are functions of the seed and the particle's number alone, so every rank makes the same list.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_INSERT_H
#define DEM_IO_INSERT_H

#include "io/crowd.h"
#include "io/dictionary.h"
#include "state/recipe.h"

/* Read every group of a scene's `insert { ... }`. */
int dem_insert_read(struct dem_crowd *, const struct dem_dict *insert, const struct dem_recipe *);

#endif
