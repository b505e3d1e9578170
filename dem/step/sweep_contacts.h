/*
 * sweep_contacts.h -- all near rows, block by block through their effects.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_SWEEP_CONTACTS_H
#define DEM_STEP_SWEEP_CONTACTS_H

#include "step/parts.h"

/* Push of every near row at time[1], the last sweep was at time[0] [s]. Advances contact memory by dt [s]: call once per step. Fails on a number that is none and on
   an overlap past the watch's limit, and names the culprits. */
int dem_sweep_contacts(struct dem_parts *, double dt, const double time[2]);

#endif
