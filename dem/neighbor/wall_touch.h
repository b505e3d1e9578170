/*
 * wall_touch.h -- where a particle touches a wall: the nearest point of each facet near it; one
 * contact per facet, none counted twice.
 *
 * A facet's nearest point that lies on another facet is dropped when the other facet is nearer
 * (a sphere on a floor does not feel the floor's edge as well), and counted once when both have it
 * as their nearest point (a convex edge is one contact). Faces of a concave edge are one contact
 * each. Where such an edge is so blunt that the contact areas, circles of radius sqrt(R d) (Hertz),
 * overlap, only the nearer one counts: the surface is nearly flat there, and two contacts would
 * give twice the force.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_NEIGHBOR_WALL_TOUCH_H
#define DEM_NEIGHBOR_WALL_TOUCH_H

#include "neighbor/wall_search.h"
#include "model/contacts.h"

struct dem_wall_touch
{
    double point[3], normal[3], distance;  /* m, unit vector to the particle, m;
                                              DBL_MAX when dropped or without a row */
    int drop;                              /* 1: another facet has this contact */
    uint32_t row;                          /* its contact row, or DEM_ROW_NONE */
    uint32_t surface;                      /* scratch of wall_springs */
};

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

/* Assign the contact rows; after every prune. */
void dem_wall_touches_set_rows(struct dem_wall_touches *, const struct dem_wall_search *,
                               const struct dem_contacts *);

/* Compute the contact points of the wall neighbors that have rows, at the present positions. */
void dem_wall_touches_update(struct dem_wall_touches *, const struct dem_wall_search *,
                             const struct dem_walls *, const struct dem_particles *);

#endif
