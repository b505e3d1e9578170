/*
 * bonds.h -- the intact bonds of a rank, and the bonds that broke: recorded by each rank, collected
 * from all ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_types.h"
#include "laws/batch.h"
#include "ranks/decomposition.h"

struct dem_state;

struct dem_bonds
{
    size_t n, capacity, intact_capacity;
    struct dem_broken_bond *broken;  /* recorded by this rank, not yet collected */
    struct dem_broken_bond *all;     /* of all ranks, as collected last */
    struct dem_bond *intact;         /* intact bonds, as listed last */
};

void dem_bonds_free(struct dem_bonds *);

/* Record the rows of a contact batch whose bond broke in this sweep. Each pair is recorded by the
   owner of its lower id. */
int dem_bonds_record(struct dem_state *, const struct dem_contact_batch *, uint32_t row, int rows);

/* List the intact bonds whose lower particle this rank owns, in `intact`; `n`: their number. */
int dem_bonds_list(struct dem_state *, int64_t *n);

/* Collective; returns this rank's status. Write the intact bonds as lines to `file` of the
   folder (VTK), and an entry for it to bonds.pvd there. Writes nothing for a state just read or
   restored, whose bonds are not known before the next sweep. */
int dem_bonds_write_lines(struct dem_state *, const char *says, const char *folder,
                          const char *file, double time);

/* Collective. Collect what all ranks have recorded since the last call in `all` of every rank,
   sorted by time and ids. */
int dem_bonds_collect(struct dem_bonds *, const struct dem_decomposition *, int64_t *n);
