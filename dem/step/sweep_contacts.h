/*
 * sweep_contacts.h -- compute the contact forces of all contact rows, batch by batch.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"
#include "step/sweep_bodies.h"

/* Contact force of every row at time[1]; the last sweep was at time[0] [s]. Advances the contact
   history by dt [s]: call it once a step. Fails on a force that is not a number and on an overlap
   above the limit; the message names the partners.
   Interleaved with it is the sweep over the particles: those whose rows are all computed are summed,
   and kicked if the pass says so, while their contact forces are in cache. No later row reads them.
   Particles left at the end are for dem_bodies_work_until. `bodies`: NULL, if no sums
   are wanted. */
int dem_sweep_contacts_and_bodies(struct dem_state *, double dt, const double time[2],
                                  struct dem_body_pass *bodies);

/* The same, with the sums of all particles in the columns force and torque, and without a kick. */
int dem_sweep_contacts_and_sum(struct dem_state *, double dt, const double time[2]);
