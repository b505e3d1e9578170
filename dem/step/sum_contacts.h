/*
 * sum_contacts.h -- from one push per row to one force and torque per particle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_SUM_CONTACTS_H
#define DEM_STEP_SUM_CONTACTS_H

#include "state/contacts.h"
#include "state/particles.h"

struct dem_sum_part
{
    size_t first, end;                                    /* particles */
    double *force, *torque;                               /* theirs, 3 numbers each [N], [N m] */
    int quiet;                                            /* 1: pushes went round in the ring, if there is one */
};

/* Each particle of the part sums its rows in fixed order. */
void dem_sum_part(const struct dem_particles *, const struct dem_contacts *, const struct dem_sum_part *);

/* All of them, into the columns force and torque. */
void dem_sum_contacts(struct dem_particles *, const struct dem_contacts *);

/* What rows have booked in the last sweep joins the columns lost and broken. */
void dem_sum_books(struct dem_particles *, const struct dem_contacts *);

#endif
