/*
 * rolling.h -- what resistances to rolling without a spring share: all that they take from the spin is heat.
 *
 *   P dt - M^2 dt^2/(2 I)      P = -M.w                            [J]
 *
 *   M    moment of the effect on i                                 [N m]
 *   w    relative spin at the start of the step                    [1/s]
 *   I    reduced inertia                                           [kg m2]
 *
 * The second term is exact for a moment that is constant over the step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_ROLLING_H
#define DEM_EFFECTS_ROLLING_H

#include "effects/block.h"

static inline void dem_rolling_energy(const struct dem_block *restrict b, struct dem_energy *restrict e)
{
    for (int c = 0; c < b->n; c++)
    {
        const dem_real power = -(e->mx[c]*b->wx[c] + e->my[c]*b->wy[c] + e->mz[c]*b->wz[c]);
        const dem_real square = e->mx[c]*e->mx[c] + e->my[c]*e->my[c] + e->mz[c]*e->mz[c];

        e->lost[c] = b->touching[c]*(power - 0.5*b->dt*square/e->inertia[c])*b->dt;
    }
}

#endif
