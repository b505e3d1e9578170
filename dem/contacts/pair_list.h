/*
 * pair_list.h -- the neighbor pairs of a rank: gap < outer skin.
 *
 * Found from cells, rarely; sorted by pair class, wall classes last. The adjacency lists the pairs
 * of each owned particle in the order of its sum: partner id, then image; walls last, by facet.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/particles.h"

enum
{
    DEM_ROW_NONE = 0x7fffffff
};

struct dem_pair
{
    uint32_t i, j;                /* records; j at a wall: index of the wall neighbor */
    uint32_t row;                 /* its contact row, or DEM_ROW_NONE */
    uint16_t class;               /* pair class of the interaction table */
    uint8_t shift;                /* code: r = x_i - x_j + shift L */
    uint8_t wall;                 /* 1: with a wall */
};

struct dem_pair_list
{
    size_t n, capacity;
    struct dem_pair *pair;
    size_t start_capacity, entry_capacity;
    uint32_t *start, *entry;      /* of each owned particle: 2 pair + side */
};

void dem_pair_list_free(struct dem_pair_list *);
size_t dem_pair_list_bytes(const struct dem_pair_list *);

/* Sort new pairs by class, and within a class by the owned particle that comes first in memory. */
int dem_pair_list_sort(struct dem_pair_list *, size_t particles, size_t classes);

/* After the sort: list the pairs of each owned particle in the order of its sum. */
int dem_pair_list_build_adjacency(struct dem_pair_list *, const struct dem_particles *);
