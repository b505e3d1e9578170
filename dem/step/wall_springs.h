/*
 * wall_springs.h -- contact history at walls: transferred from facet to facet of a surface that is
 * nearly flat.
 *
 * A curved wall consists of many facets. The contact of a sphere that rolls along it goes from one
 * facet to the next, and its friction spring has to go with it, or friction begins anew at every
 * facet. Facets are one surface to a sphere when their normals at the contact points differ by less
 * than 30 degrees from the deepest contact's; the contacts on one surface share their springs.
 * Before a step these are divided anew, so that the friction T of all together does not change and
 * each contact has the same fraction of it as of the normal force:
 *
 *   T = sum_k w_k xi_k,   xi_k' = T d_k/sum_k w_k d_k,   w = d^(p-1): 1 or sqrt(d)
 *
 *   xi   spring, turned by the smallest rotation from its own plane to the plane of the
 *        deepest contact, and back
 *   d    overlap
 *   p    exponent of the normal law: forces go with d^p, tangential stiffness with d^(p-1)
 *        (Hertz and Mindlin: 3/2)
 *
 * A contact that another facet has taken over in this step (see wall_touch.h) adds its spring once
 * more, with the w of the deepest contact; its other history goes to contacts that are new.
 *
 * The rotation of springs with the pair, also on a rotating wall, is done by the effects
 * (laws/rotate.h).
 *
 * walls/facet_springs.h has the arithmetic; the history of effects of the stages BOND and FILM stays
 * with the facet where it was made.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"

/* Redistribute the history of wall contacts; after the contact points are known, before the effects
   act. */
void dem_wall_springs_redistribute(struct dem_state *);
