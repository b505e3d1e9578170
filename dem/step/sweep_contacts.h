/*
 * sweep_contacts.h -- all near rows, block by block through their effects, and the sum of their pushes on each particle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_SWEEP_CONTACTS_H
#define DEM_STEP_SWEEP_CONTACTS_H

#include "step/parts.h"

/* Push of every near row. Advances contact memory by dt [s]: call once per step. Fails on a number that is none and on
   an overlap past the watch's limit, and names the culprits. */
int dem_sweep_contacts(struct dem_parts *, double dt);

/* Each particle sums its rows in fixed order into the columns force and torque. */
void dem_sweep_sum(struct dem_particles *, const struct dem_contacts *);

#endif
