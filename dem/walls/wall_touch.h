/*
 * wall_touch.h -- where a particle touches a wall: the nearest point of each facet near it; one
 * contact per facet, none counted twice.
 *
 * A facet's nearest point that lies on another facet is dropped when the other facet is nearer
 * (a sphere on a floor does not feel the floor's edge as well), and counted once when both have it
 * as their nearest point (a convex edge is one contact). Faces of a concave edge are one contact
 * each.
 *
 * Faces of a blunt concave edge (less than 20 degrees) are one contact, with the potential of an
 * overlap that passes smoothly from one face to the other:
 *
 *   d = (d_1^p + d_2^p)^(1/p),  F = f(d) grad d,  grad d = sum_i (d_i/d)^(p-1) n_i,  p = 1/sin a
 *
 *   d_i, n_i  overlap with face i, continued beyond the edge as a plane, and its normal
 *   f         force of the normal law, ~ d^m
 *   a         angle of the edge
 *
 * So the force is continuous in position, and has a potential: elastic bounces keep their energy. p
 * is so large that a face adds nothing where its edge is out of reach (exp(-sqrt(2R/d))), and that
 * a sphere on an edge has little more overlap than on one face, 2^(1/p) times: 12 % more at 10
 * degrees, 1 % at 1 degree. The law gets the overlap at which its force is f |grad d|, and the
 * direction of grad d. At an edge with more faces p is their mean, weighted by d_i^p. At a sharper
 * edge p would be m + 1, which is the sum of both contacts; they are continuous without it as the
 * plane of one is not in reach on the other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "walls/facet_touch.h"
#include "walls/wall_search.h"

struct dem_wall_touches
{
    struct dem_wall_touch *touch;  /* one for each wall neighbor of the search */
    size_t capacity;
    size_t listed, list_capacity;      /* wall neighbors that have a row: only
                                      these are updated in a step */
    uint32_t *list;
    size_t shared, shared_capacity;    /* first wall neighbor of each particle with several
                                      wall contacts, duplicates included */
    uint32_t *shared_first;
};

void dem_wall_touches_free(struct dem_wall_touches *);

/* Allocate one contact point per wall neighbor; after every search, which makes the previous ones
   invalid. */
int dem_wall_touches_reserve(struct dem_wall_touches *, const struct dem_wall_search *);

/* Compute the contact points of the wall neighbors that have rows, at the present positions. */
void dem_wall_touches_update(struct dem_wall_touches *, const struct dem_wall_search *,
                             const struct dem_walls *, const struct dem_particles *);
