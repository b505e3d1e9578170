/*
 * profile_text.h -- the profile of a run as text: where its processor time went.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_RUN_PROFILE_TEXT_H
#define DEM_RUN_PROFILE_TEXT_H

#include "dem_query.h"
#include "core/text.h"

/* Writes nothing if no step was made. Returns DEM_OK or an error. */
int dem_profile_write(struct dem_text *, const struct dem_profile *);

#endif
