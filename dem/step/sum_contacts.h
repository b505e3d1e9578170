/*
 * sum_contacts.h -- sum the contact forces of the rows to one force and one torque per particle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "contacts/contacts.h"
#include "particles/particles.h"

struct dem_contact_sum     /* of the rows of a particle; a cache line */
{
    _Alignas(64) double force[4];    /* N    three components, and a number without meaning */
    double torque[4];                /* N m  three components, and 0 */
};

struct dem_sum_slice                                       /* a contiguous slice of particles */
{
    size_t first, end;       /* particles */
    struct dem_contact_sum *sum;         /* results, of particle `first` in [0]; one more than the
                                            slice has is read, but not used */
};

/* Each particle of the slice sums its rows in the order of partner ids. */
void dem_sum_slice(const struct dem_particles *, const struct dem_contacts *,
                   const struct dem_sum_slice *);

/* The results of a slice into the columns force and torque. */
void dem_sum_store(struct dem_particles *, const struct dem_sum_slice *);

/* Add the energies lost [J] and the bonds broken in the last sweep to the columns lost and broken
   of the particles. */
void dem_sum_bond_energies(struct dem_particles *, const struct dem_contacts *);
