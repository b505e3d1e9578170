/*
 * wall_springs.h -- what contacts with walls remember, where it is not theirs alone: handed on from region to region of a
 * surface that is nearly flat.
 *
 * A round wall made of facets is many regions. The contact of a sphere that rolls along it goes from one to the next, and
 * its friction spring must go with it, or friction begins anew at every facet. Regions are one surface to a sphere when their
 * normals there differ by less than 30 degrees from that of the deepest contact; the contacts on one surface have their
 * springs in common. Before a step they are divided anew, so that the friction T of all together stays and each
 * contact has a part of it as it has of the normal force:
 *
 *   T = sum_k w_k xi_k,   xi_k' = T d_k/sum_k w_k d_k,   w = d^(p-1): 1 or sqrt(d)
 *
 *   xi   spring, turned by the smallest rotation from its own plane to that of the deepest contact, and back
 *   d    overlap; p exponent of the normal law: forces go with d^p, tangential stiffness with d^(p-1) (Hertz and Mindlin: 3/2)
 *
 * A contact that another region has taken over in this step (see wall_touch) adds its spring once more, with the deepest
 * one's w; what it remembers besides springs goes to contacts that are new.
 *
 * That they turn with the pair, also on a wall that turns, is the effects' own matter, by the half-step normal and the swing.
 *
 * A vector is what an effect remembers under three names in a row of which the first ends in _x. What effects of the stages
 * BOND and FILM remember stays with the region where it was made.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_WALL_SPRINGS_H
#define DEM_STEP_WALL_SPRINGS_H

#include "step/parts.h"

/* After the touches are known, before the effects act. */
void dem_wall_springs(struct dem_parts *);

#endif
