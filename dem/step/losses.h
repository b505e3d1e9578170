/*
 * losses.h -- who was taken out of the run, and who passed through a wall: kept by each rank, told by all together.
 *
 * Why it happened stands in loss_cause.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_LOSSES_H
#define DEM_STEP_LOSSES_H

#include "dem.h"
#include "space/pieces.h"
#include "state/particles.h"

struct dem_losses
{
    size_t n, room, all_room, pass_room;
    struct dem_loss *loss;                                /* of this rank, not yet told */
    struct dem_loss *all;                                 /* of all ranks, as told last */
    size_t passes;
    uint32_t *pass;                                       /* rows whose particle came out behind its wall in this sweep */
};

void dem_losses_free(struct dem_losses *);

/* One more: the particle as it is now [s]. `removed` is 0 when it stays in the run. */
int dem_losses_note(struct dem_losses *, const struct dem_particle *, double time, int removed, const char *cause);

/* Collective. What all ranks have noted since the last call, by time and id, in `all` of every rank. */
int dem_losses_tell(struct dem_losses *, const struct dem_pieces *, int64_t *n);

#endif
