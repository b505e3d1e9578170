/*
 * gather_partners.h -- gather the partners of the pairs of a contact batch into columns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/scalar.h"
#include "contacts/contact_batch.h"
#include "ranks/dem_state.h"

/* Fill the gathered columns, and the optional columns of spin and scalars, for all lanes.
   `first`: partners of the first lane; the other lanes follow. `needs`: optional columns
   that the effect list of the class uses (enum dem_needs). */
void dem_gather_pairs(struct dem_contact_workspace *, const struct dem_state *, unsigned needs,
                      const struct dem_row_partners *first);

/* The column of a batch that the k-th scalar of dem_particles.batch fills, or NULL when no effect
   with these needs reads it. In the first evaluation of a run the fluid is not known: there it stays
   0. */
static inline double *dem_contact_batch_column(struct dem_contact_batch *b,
                                               const struct dem_particles *particles, int k,
                                               unsigned needs)
{
    const struct dem_scalar_batch *const to = particles->batch.at[k].to;

    return needs & to->contact_needs && b->dt > 0.0 ? (double *)(void *)((char *)b + to->contact)
                                                    : NULL;
}

static inline const double *dem_batch_column_values(const struct dem_particles *particles, int k)
{
    return particles->column[particles->batch.at[k].column].data;
}
