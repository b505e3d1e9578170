/*
 * body_window.h -- begin and end of a coupling window, for the effects on single particles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/domain.h"
#include "laws/interaction_table.h"
#include "particles/particles.h"

/* Begin a coupling window: clear the columns that are passed to the fluid, and compute what is
   constant over its steps. */
void dem_bodies_begin_window(struct dem_particles *, const struct dem_effect_list *effects);

/* Only the constants of the window, voidage factors of drag laws and added mass: for a window that
   is continued. */
void dem_bodies_window_constants(struct dem_particles *, const struct dem_effect_list *effects);

/* End a coupling window of length `window` [s]: compute the response R of each particle from its
   drag impulse (see body_window.c). */
void dem_bodies_end_window(struct dem_particles *, const struct dem_domain *, double window);
