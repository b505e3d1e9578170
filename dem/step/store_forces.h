/*
 * store_forces.h -- store the contact forces of a batch in the slots of its rows
 * (contacts/contact_forces.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/batch.h"
#include "contacts/contacts.h"

struct dem_batch_forces                       /* of the rows of a batch */
{
    struct dem_contact_force *force;
    struct dem_contact_moment *moment;      /* NULL: the scene has none */
};

/* The slots of a batch, from the slot of its first row on. */
struct dem_batch_forces dem_store_target(const struct dem_contact_forces *, uint32_t slot);

/* Store the contact forces and moments of a batch. The lever arm is the radius minus `factor` times
   the overlap (1/2 at a pair, 1 at a wall). In a class that acts past touching, the gap is a negative
   overlap. Lanes past the last row are written to the padding of their class. Returns 1 when a row may
   overlap by more than `overlap_so_far` (1, of the smaller diameter), or its force is not a number. */
int dem_store_forces(const struct dem_contact_batch *, double factor, int past_touching,
                     double overlap_so_far, struct dem_batch_forces);

/* Copy the deferred rows before `end`, which are summed after the ring has wrapped around, to their
   own slots. `copied`: number of deferred rows copied so far. Returns this number after the
   call. */
size_t dem_store_deferred(struct dem_contact_forces *, size_t copied, uint32_t end);

/* In an observed step: count the contacts of owned particles in a batch, and keep its forces per row
   where they are asked for. n: owned particles. */
void dem_store_observed(struct dem_contacts *, const struct dem_batch_forces *, uint32_t row,
                        int rows, size_t n);
