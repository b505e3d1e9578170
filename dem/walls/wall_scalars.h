/*
 * wall_scalars.h -- conditions of a wall for particle scalars.
 *
 *     temperature { value 326; start 7; }      or flux, or value and film
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "input/dictionary.h"
#include "laws/interaction_table.h"
#include "walls/walls.h"

/* Read the conditions of a wall, for all scalars; none stays insulated. */
int dem_scalar_wall_read(const struct dem_dict *, const struct dem_interaction_table *,
                         struct dem_wall *);
