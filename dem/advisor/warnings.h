/*
 * warnings.h -- list likely mistakes in the scene before the first step: one numbered list, each item
 * with the entry to change.
 *
 *   no contact law       walls, and no normal law acts between them and particles
 *   driven               driven particles and walls, between which there is no force
 *   walls by force       and frozen or driven particles, likewise
 *   gravity              absent, or along +y or +z
 *   no drag              a fluid, and no drag law
 *   density              below 50 kg/m3: kg/m3 meant, g/cm3 given?
 *   diameter             above 0.5 m: m meant, mm given?
 *   Biot number          above 0.1
 *   stiffness            youngsModulus above 1e10 Pa and more than 1e6 steps ahead
 *   fluid step           of more than 1e4 DEM steps: with its time
 *   fluid step           in which a particle crosses more than half of run.resolution: at its own
 *                        speed, a stream's, or the speed that fluid and gravity give it in the step
 *   cells                narrower than 3/4 of a particle, also after smoothing; or wider than 1000
 *                        particles: the mesh may be in mm
 *   impact speed         particles, streams, a wall (along its normal) or a fluid with drag faster
 *                        than impactSpeed, where the overlap of such an impact is above 5 % of a
 *                        diameter; above 20 % also slower ones; above 100 % at impactSpeed itself
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "advisor/plan.h"

/* Collective. `own`: n sentences of the program, before others but those on the scene's entries.
   Nothing is added to the text when there is nothing to warn of. */
int dem_warnings_write(struct dem_text *, const struct dem_plan *, int n, const char *const *own);
