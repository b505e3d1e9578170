/*
 * bond_pairs.h -- mark the pairs of particles that the scene lists to be bonded.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"

/* Collective, after the first contact rows have been built: mark the rows of the listed pairs for
   the effects that have a listed_column. `ids`: `count` ids, two different ones a pair.
   Fails on a pair that is not a candidate contact, and names it. */
int dem_bond_pairs_mark(struct dem_state *, const int64_t *ids, size_t count);
