/*
 * bonds.h -- the bonds of this rank as they are, and those that broke: kept by each rank, told by all together.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_BONDS_H
#define DEM_STEP_BONDS_H

#include "dem.h"
#include "effects/block.h"
#include "space/pieces.h"

struct dem_parts;

struct dem_bonds
{
    size_t n, room, all_room, hold_room;
    struct dem_break *broke;                              /* noted by this rank, not yet told */
    struct dem_break *all;                                /* of all ranks, as told last */
    struct dem_bond *hold;                                /* as listed last */
};

void dem_bonds_free(struct dem_bonds *);

/* Note the rows of a block that broke in this sweep; each pair is noted by the owner of its lower particle. */
int dem_bonds_note(struct dem_parts *, const struct dem_block *, uint32_t row, int rows);

/* The bonds that hold and whose lower particle is this rank's, in `hold`. */
int dem_bonds_list(struct dem_parts *, int64_t *n);

/* Collective, the status is the first rank's own. A picture of the bonds that hold in `file` of the folder, with its place in bonds.pvd
   there. Of a state just read or given back nothing is known: no picture. */
int dem_bonds_lines(struct dem_parts *, const char *says, const char *folder, const char *file, double time);

/* Collective. What all ranks have noted since the last call, by time and ids, in `all` of every rank. */
int dem_bonds_tell(struct dem_bonds *, const struct dem_pieces *, int64_t *n);

#endif
