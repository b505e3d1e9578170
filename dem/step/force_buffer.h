/*
 * force_buffer.h -- where the contact forces of a batch are stored: one record a row, or the ring
 * buffer of model/contacts.h.
 *
 * In an unobserved step nothing but the sum over each particle reads contact forces. Then most of
 * them are written to the ring buffer, which stays in cache, and read again before it wraps around.
 * Deferred rows are summed later than that; their forces are copied to their own records as well.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_FORCE_BUFFER_H
#define DEM_STEP_FORCE_BUFFER_H

#include "effects/batch.h"
#include "model/contacts.h"

struct dem_force_slot                       /* of the rows of a batch */
{
    struct dem_contact_force *force;
    struct dem_contact_moment *moment;      /* NULL: the scene has none */
};

/* Where the forces of the batch that begins at `row` go: into the ring buffer if `buffered` is set,
   else to the rows' own records. */
struct dem_force_slot dem_force_buffer_slot(const struct dem_contacts *, uint32_t row,
                                            int buffered);

/* Store the contact forces and moments of a batch. The lever arm is the radius minus `factor` times the overlap
   (1/2 at a pair, 1 at a wall). In a class that acts past touching, the gap is a negative overlap.
   Lanes past the last row are written to the padding of their class. Returns 1 when a row may overlap
   by more than `max_overlap` of the smaller diameter, or its force is not a number. */
int dem_force_buffer_store(const struct dem_contact_batch *, double factor, int past_touching,
                           double max_overlap, struct dem_force_slot);

/* Copy the deferred rows before `end`, which are summed after the ring buffer has wrapped around,
   to their own records. `copied`: number of deferred rows copied so far. Returns this number after
   the call. */
size_t dem_force_buffer_copy_deferred(struct dem_contacts *, size_t copied, uint32_t end);

#endif
