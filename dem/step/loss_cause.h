/*
 * loss_cause.h -- why a particle was lost, as far as its last step tells.
 *
 * Known of a particle that is outside: the side of the domain, how fast it was, the walls in its reach and who pressed it
 * in the last sweep. That names the usual causes: no wall there, a step too long, a contact too soft, the pressure of
 * others. A particle that came through a wall earlier and flew on has its passage in the list as well, with the same id.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_LOSS_CAUSE_H
#define DEM_STEP_LOSS_CAUSE_H

#include "step/parts.h"

enum
{
    DEM_CAUSE_SIZE = sizeof ((struct dem_loss *)0)->cause
};

/* Of owned particle i outside the domain, before lists are found anew. */
void dem_loss_cause_outside(const struct dem_parts *, size_t i, char cause[DEM_CAUSE_SIZE]);

/* Note all particles that passed a wall in the last sweep (parts.losses.pass). After the sweep, before the sums. */
int dem_loss_note_passes(struct dem_parts *);

#endif
