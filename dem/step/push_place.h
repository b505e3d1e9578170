/*
 * push_place.h -- where the pushes of a block of rows go: at their own rows, or in the ring of state/contacts.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_PUSH_PLACE_H
#define DEM_STEP_PUSH_PLACE_H

#include "effects/block.h"
#include "state/contacts.h"

struct dem_push_place                                     /* of a block's pushes: one of the two is there */
{
    struct dem_push *push;
    struct dem_push_single *single;
};

struct dem_push_place dem_push_place(const struct dem_contacts *, uint32_t row, int ring);

/* The arm is the radius less `share` of the overlap, or, of a chain that acts past touching, less that share of the gap, which is
   negative. Lanes past the last row fall on the padding of their class. */
void dem_push_out(const struct dem_block *, double share, int past_touching, const struct dem_push_place *);

/* Of the rows before `end`, those that are summed when the ring has come round: copied to their own places, too. `far`: so many have
   been. Returns how many are then. */
size_t dem_push_keep_far(struct dem_contacts *, size_t far, uint32_t end);

#endif
