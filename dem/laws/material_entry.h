/*
 * material_entry.h -- the entry `material` of a wall, of a group of `insert` or of a stream.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "input/dictionary.h"
#include "laws/interaction_table.h"

/* The index of the material that the entry names. A scene with a single material need not name
   it. */
int dem_material_entry_read(const struct dem_dict *, const struct dem_interaction_table *,
                            int *material);
