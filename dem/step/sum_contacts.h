/*
 * sum_contacts.h -- from one push per row to one force and torque per particle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_SUM_CONTACTS_H
#define DEM_STEP_SUM_CONTACTS_H

#include "state/contacts.h"
#include "state/particles.h"

/* Each particle of [first, end) sums its rows in fixed order into the columns force and torque. */
void dem_sum_contacts(struct dem_particles *, const struct dem_contacts *, size_t first, size_t end);

/* What rows have booked in the last sweep joins the columns lost and broken. */
void dem_sum_books(struct dem_particles *, const struct dem_contacts *);

#endif
