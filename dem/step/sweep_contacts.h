/*
 * sweep_contacts.h -- compute the contact forces of all contact rows, batch by batch.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_SWEEP_CONTACTS_H
#define DEM_STEP_SWEEP_CONTACTS_H

#include "simulation/dem_state.h"
#include "step/sweep_bodies.h"

/* Contact force of every row at time[1]; the last sweep was at time[0] [s]. Advances the contact
   history by dt [s]: call it once a step. Fails on a force that is not a number and on an overlap
   above the limit; the message names the partners. */
int dem_sweep_contacts(struct dem_state *, double dt, const double time[2]);

/* The same, interleaved with the sweep over the particles: those whose rows are all computed are
   summed and kicked while their contact forces are in cache. No later row reads them. Particles not
   kicked at the end are left to dem_bodies_kick_until. */
int dem_sweep_contacts_and_bodies(struct dem_state *, double dt, const double time[2],
                                  struct dem_body_pass *bodies);

#endif
