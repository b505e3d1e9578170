/*
 * skins.h -- tuning of the skins of the neighbor lists from counted work and speeds, never from a
 * clock.
 *
 * The unit of work is one contact row in one step. Let s and S be the inner and outer skin [m], R
 * the number of rows at zero skin, k the rows per meter of skin, u (since the last prune) and U
 * (since the last search) the displacement per step relative to the common displacement [m], v the
 * same with the common one included (it determines how soon the cheap bound is exceeded and
 * positions are evaluated), and n the number of particles. Let a, b, c, d be the costs of
 * evaluating the displacement of a particle, pruning a pair, and searching per particle and per
 * pair found (displacement_cost, prune_cost, search_cost, pair_cost of skins.c). The work per step
 *
 *   R + k s + (2 v/s) a n + (2 u/s) b (R + k S) + (2 U/S) (c n + d (R + k S))
 *
 * is minimal at
 *
 *   s^2 = 2 (v a n + u b (R + k S))/k
 *   S^2 = (U/u) (c n + d R) s/(b k)
 *
 * All numbers are sums or maxima over ranks, so the same skins are chosen on any number of ranks.
 * Results do not depend on the skins.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "walls/walls.h"

struct dem_skins
{
    int tuned;                       /* 0: skins are fixed */
    double min, max;                 /* m: limits */
    double skin[DEM_LISTS];          /* m: for the next list */
    double rate[DEM_LISTS];          /* m per step: u, U; below 0: not known yet */
    double fastest;                  /* m per step: v, of the fastest particle */
    int64_t steps[DEM_LISTS];        /* since the list was made */
    int64_t next_check;              /* number of steps after which a list that has not been made
                                        again is checked */
    double in_use[DEM_LISTS];        /* m: skins of the present lists */
    int64_t counted[3];              /* particles, pairs, rows of all ranks at the last search */
    double counted_skin[DEM_LISTS];  /* m: the skins then */
};

/* Fixed at skin[0], skin[1] [m], or tuned between `min` and `max` [m], beginning with them. */
void dem_skins_init(struct dem_skins *, const double skin[DEM_LISTS], int tuned, double min,
                    double max);

/* 1 when the state, for example from a snapshot, is valid: skins within [0, max], numbers finite,
   counters below their limits. */
int dem_skins_are_valid(const struct dem_skins *);

/* Report that a list has been made with its next skin (first function); that both have been made,
   with these numbers of particles, pairs and rows (second). */
void dem_skins_list_made(struct dem_skins *, enum dem_list);
void dem_skins_count(struct dem_skins *, const int64_t counted[3]);

/* Report one more step, in which no particle moved further than `fastest` [m]. Returns 1 when it is
   time to check whether the skins have become too thick, for example for a bed that has settled. */
int dem_skins_step(struct dem_skins *, double fastest);

/* Choose both skins; particles have moved `distance` [m] since this list was made. */
void dem_skins_choose(struct dem_skins *, enum dem_list, double distance);

/* 1 when the skin chosen is so much thinner than the one in use that making the list again pays. */
int dem_skins_pays(const struct dem_skins *, enum dem_list);
