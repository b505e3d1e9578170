/*
 * program_scalars.h -- text of a program for particle scalars (scalars.cl).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/text.h"
#include "laws/interaction_table.h"

/* The scalars of a law, of a contact or of a particle, into the row; what it adds to the first one,
   back. */
void dem_device_scalars_before(struct dem_text *, const struct dem_effect_entry *, int contact);
void dem_device_scalars_after(struct dem_text *, const struct dem_effect_entry *, int contact);

/* SCALARS, RATES, and where the scalars of lists and their exchange are among the columns and how they
   change. */
void dem_device_scalars_text(struct dem_text *, const struct dem_interaction_table *);
