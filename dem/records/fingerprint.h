/*
 * fingerprint.h -- 64-bit hash of a particle and of the history of a contact row: the fingerprint
 * of a state.
 *
 * The fingerprint of a state is the sum modulo 2^64 over its particles and its contacts with
 * history, so neither their order nor the number of ranks matters. It covers id, position, velocity
 * and spin of particles, and names and history of contacts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "contacts/contacts.h"
#include "particles/particles.h"

/* Hash of one particle, and of one contact with `columns` numbers of history. */
uint64_t dem_fingerprint_particle(const struct dem_particle *);

/* A particle scalar of it: its name and value. */
uint64_t dem_fingerprint_scalar(int64_t id, const char *name, double value);
uint64_t dem_fingerprint_contact(const struct dem_contact_key *, const double *history,
                                 int columns);
