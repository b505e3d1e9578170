/*
 * lost_cause.h -- the probable cause of the loss of a particle, from its last time step.
 *
 * The side of the domain that a particle crossed, its speed, the walls near it and the overlaps of its
 * contacts in the last sweep are known. They point to the usual causes: no wall
 * there, a time step too long, a contact too soft, pressure by other particles. A particle that
 * crossed a wall earlier and flew on has that crossing in the list as well, with the same id.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"
#include "records/lost_particles.h"

enum
{
    DEM_LOST_CAUSE_SIZE = sizeof ((struct dem_loss *)0)->cause
};

/* Cause for owned particle i outside the domain, before lists are rebuilt. */
void dem_lost_cause_outside(const struct dem_state *, size_t i, char cause[DEM_LOST_CAUSE_SIZE]);

/* Record all particles that crossed a wall in the last sweep (the rows in `pass` of the lost
   particles). After the sweep, before the forces are summed. */
int dem_lost_cause_record_crossings(struct dem_state *);
