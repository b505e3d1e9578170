/*
 * neighbor_update.h -- after a drift: receive the ghosts, and keep, prune or rebuild the neighbor
 * lists, decided from bounds on the displacements.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"

/* Not collective, but the same on all ranks: 1 when they have to agree in this step, as particles
   may have used up a skin, or may have to be inserted or removed. `moved` [m]: bound of the
   displacement of any particle of any rank since they agreed last. */
int dem_neighbor_agreement_due(const struct dem_state *, double moved);

/* Collective, after the drift and the sending of ghost data. `moved` [m]: upper bounds of the
   displacement of any particle in each of the n last steps; n = 0: the ranks have not agreed in this
   step, and lists are kept. `observed`: 1 when positions are read after the step, so that they have
   to be inside a periodic box up to half a skin. Ghosts are up to date afterwards. */
int dem_neighbor_update(struct dem_state *, const double *moved, int n, int observed);

/* Collective, within a step that the host makes after all: contacts that are on a device come back, and lists are
   made. */
int dem_neighbor_take_back(struct dem_state *);

/* Collective, after the drift. `changes`: 1 when particles enter or leave in this step; passages through planes
   are counted, and arrivals have positions. */
int dem_neighbor_check_particles(struct dem_state *, int *changes);
