/*
 * sweep_contacts.h -- all near rows, block by block through their effects.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_SWEEP_CONTACTS_H
#define DEM_STEP_SWEEP_CONTACTS_H

#include "step/parts.h"
#include "step/sweep_bodies.h"

/* Push of every near row at time[1], the last sweep was at time[0] [s]. Advances contact memory by dt [s]: call once per step. Fails on a number that is none and on
   an overlap past the watch's limit, and names the culprits. */
int dem_sweep_contacts(struct dem_parts *, double dt, const double time[2]);

/* The same, and `bodies` goes along: whose rows are all done is summed and kicked while they are at hand, before the next rows. No
   row to come reads him. Who has not been kicked at the end is left to dem_bodies_until. */
int dem_sweep_contacts_and(struct dem_parts *, double dt, const double time[2], struct dem_body_pass *bodies);

#endif
