/*
 * survey.h -- what is there, over all ranks: particles by material and together, lists, bytes. Changes nothing.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_SURVEY_H
#define DEM_STEP_SURVEY_H

#include "step/parts.h"

struct dem_stock                                          /* of one material, or of all */
{
    int64_t n, frozen;
    double least, most;                                   /* m   diameters; infinite and 0 when there are none */
    double diameters, squares, volume, mass;              /* m, m2, m3, kg: sums */
    double moving_volume, moving_mass;                    /* m3, kg: of those that are not frozen */
};

struct dem_survey
{
    struct dem_stock all, material[DEM_MATERIALS];
    double fluid_density, fluid_viscosity;                /* kg/m3, Pa s: means at the particles; 0 without fluid */
    int64_t pairs, rows;                                  /* listed pairs, near rows (those at borders once a rank) */
    double bytes, most_bytes;                             /* held by all ranks, by the one with most */
};

/* Collective. The same numbers on all ranks, whatever their number (but for lists and bytes). */
void dem_survey_take(const struct dem_parts *, struct dem_survey *);

#endif
