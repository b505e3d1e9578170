/*
 * wall_touch.h -- where a particle touches a wall: the nearest point of each region near it, one contact per flat region
 * and none twice.
 *
 * A region's nearest point that lies on another region is dropped when the other is nearer (the sphere on a floor does
 * not feel the floor's edge as well) and counted once when both have it as their nearest (a convex edge is one contact). Faces
 * of a concave edge are one contact each; but where the edge is so blunt that the areas of contact, circles of radius
 * sqrt(R d) (Hertz), lie over each other, only the nearer one counts: the surface is nearly flat there, and two contacts would push
 * twice as hard.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_WALL_TOUCH_H
#define DEM_STEP_WALL_TOUCH_H

#include "space/wall_search.h"
#include "state/contacts.h"

struct dem_wall_touch
{
    double point[3], normal[3], distance;                 /* m, unit vector to the particle, m; huge when dropped or without a row */
    int drop;                                             /* 1: another region has this contact */
    uint32_t row;                                         /* its near row, or DEM_ROW_NONE */
    uint32_t surface;                                     /* scratch of wall_springs */
};

struct dem_wall_touches
{
    struct dem_wall_touch *touch;                         /* one a wall near */
    size_t room;
    size_t listed, list_room;                             /* nears that have a row: only these are looked at in a step */
    uint32_t *list;
    size_t shared, shared_room;                           /* particles that have several contacts, or had: the first near of each */
    uint32_t *share;
};

void dem_wall_touches_free(struct dem_wall_touches *);

/* Room for one touch per wall near; after every search, which leaves none of the touches before. */
int dem_wall_touches_fit(struct dem_wall_touches *, const struct dem_wall_search *);

/* Tell each touch its row; after every prune. */
void dem_wall_touches_rows(struct dem_wall_touches *, const struct dem_wall_search *, const struct dem_contacts *);

/* Fill the touches that have rows, at the present positions. */
void dem_wall_touches_update(struct dem_wall_touches *, const struct dem_wall_search *, const struct dem_walls *,
                             const struct dem_particles *);

#endif
