/*
 * biot.h -- Biot number of the particles of a scene with effects of heat.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_ADVISOR_BIOT_H
#define DEM_ADVISOR_BIOT_H

#include "advisor/plan.h"
#include "laws/relevance.h"

#define DEM_BIOT_LIMIT 0.1    /* above it a particle has no uniform temperature */

struct dem_biot    /* the largest of a scene */
{
    double number;                          /* 0: no effect of heat, or no conductivity given */
    const struct dem_material *material;    /* of the particle */
    const struct dem_material *other;       /* of its partner in contact; NULL: the fluid */
};

void dem_biot_number(const struct dem_plan *, const struct dem_regime *, struct dem_biot *);

#endif
