/*
 * fingerprint.h -- what of a particle and of a contact's memory counts in the 64-bit fingerprint of a state.
 *
 * The fingerprint of a state is the sum modulo 2^64 over its particles and its remembered contacts, so neither their
 * order nor the number of ranks matters.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_FINGERPRINT_H
#define DEM_IO_FINGERPRINT_H

#include "state/contacts.h"
#include "state/particles.h"

uint64_t dem_fingerprint_particle(const struct dem_particle *);
uint64_t dem_fingerprint_row(const struct dem_carried *, const double *memory, int memories);

#endif
