/*
 * effect_numbers.h -- settings of an effect in use, for numbers of a scene.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/interaction_table.h"

/* Settings of an effect as prepared for the first pair of materials, or for bodies; NULL if it is
   not in use. */
const void *dem_effect_settings(const struct dem_interaction_table *, const struct dem_effect *);
