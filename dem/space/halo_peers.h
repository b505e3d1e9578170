/*
 * halo_peers.h -- who is near whom.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_SPACE_HALO_PEERS_H
#define DEM_SPACE_HALO_PEERS_H

#include "space/halo.h"

/* The box of a rank: infinite at the outside, up to the domain's faces along periodic axes. */
void dem_halo_box(const struct dem_halo *, const struct dem_domain *, int rank, double box[2][3]);

/* Into `peer`, ascending: the ranks whose boxes, or images of them, come within `reach` [m] of this one's along every axis. */
int dem_halo_find_peers(struct dem_halo *, const struct dem_domain *, double reach);

#endif
