/*
 * gather_partners.h -- gather the partners of the pairs of a contact batch into columns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_GATHER_PARTNERS_H
#define DEM_STEP_GATHER_PARTNERS_H

#include "model/contact_batch.h"
#include "simulation/dem_state.h"

/* Fill the gathered columns, and the optional columns spin and viscosity, for all lanes. `first`:
   partners of the first lane; those of the other lanes follow. `needs`: optional columns that the
   effect list of the class uses (enum dem_needs). */
void dem_gather_pairs(struct dem_contact_workspace *, const struct dem_state *, unsigned needs,
                      const struct dem_row_partners *first);

#endif
