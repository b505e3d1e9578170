/*
 * sample.h -- a block of spheres with the scene's own physics, to be timed.
 *
 * Spheres of the mean diameter and of the commonest material on a body-centred lattice that just touches, in a periodic box, with the
 * scene's own recipe and skins. Each has 8 partners that touch and 6 more within a usual outer skin, so 4 rows and 7 pairs, a little more
 * than a settled bed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_PLAN_SAMPLE_H
#define DEM_PLAN_SAMPLE_H

#include "step/parts.h"
#include "step/survey.h"

/* Make one with lists that stand; `without`: an effect that is left out, or NULL. It borrows the scene's recipe, so it goes before the
   scene does. To be freed also after an error. */
int dem_sample_make(struct dem_parts *sample, const struct dem_parts *scene, const struct dem_survey *, const char *without);
void dem_sample_free(struct dem_parts *sample);

#endif
