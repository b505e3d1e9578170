/*
 * neighbourhood.h -- after a drift: the lists of neighbours are good, pruned or renewed, from bounds on how far anyone has come.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_NEIGHBOURHOOD_H
#define DEM_STEP_NEIGHBOURHOOD_H

#include "step/parts.h"

/* Collective. Nobody has moved further than `fastest` [m] in this step. `seen`: positions will be looked at from outside after it. */
int dem_neighbourhood(struct dem_parts *, double fastest, int seen);

#endif
