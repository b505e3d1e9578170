/*
 * regime.h -- dimensionless numbers of a scene, and verdicts on its effects.
 *
 * Formulas and sources of the numbers: regime.c; of the verdicts: verdicts.c and each effect.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_ADVISOR_REGIME_H
#define DEM_ADVISOR_REGIME_H

#include "advisor/plan.h"
#include "laws/relevance.h"

/* Fills in the numbers that are known. */
void dem_regime_set(const struct dem_plan *, struct dem_regime *);

/* Settings of an effect as prepared for the first pair of materials, or for bodies; NULL if it is
   not in use. */
const void *dem_regime_settings(const struct dem_plan *, const struct dem_effect *);

/* Adds a verdict on each effect that is in use, and on each one that is not and is called for. */
void dem_verdicts_add(struct dem_plan *, const struct dem_regime *);

/* Collective. Measures the cost of each negligible effect. */
int dem_verdicts_measure_costs(struct dem_plan *);

#endif
