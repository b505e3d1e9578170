/*
 * bond_pairs.h -- the pairs of particles that the scene wants bonded.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_BOND_PAIRS_H
#define DEM_STEP_BOND_PAIRS_H

#include "step/parts.h"

/* Collective, once the first near rows are there: mark the rows of the listed pairs, `count` ids, two different ones a pair,
   for the effects that remember "bond_asked". Fails on a pair that is no pair of near particles, and names it. */
int dem_bond_pairs_ask(struct dem_parts *, const int64_t *ids, size_t count);

#endif
