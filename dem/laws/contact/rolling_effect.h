/*
 * rolling_effect.h -- what the descriptors of rolling resistances share: relevance; the energy that
 * those without a spring dissipate.
 *
 *   P dt - M^2 dt^2/(2 I)      P = -M.w                            [J]
 *
 *   M    moment of the effect on i                                 [N m]
 *   w    relative spin at the start of the step                    [1/s]
 *   I    reduced inertia                                           [kg m2]
 *
 * All energy taken from the spin is dissipated. The second term is exact for a moment that is
 * constant over the step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_ROLLING_EFFECT_H
#define DEM_LAWS_ROLLING_EFFECT_H

#include "laws/batch.h"
#include "dem_numbers.h"

#include <stddef.h>

/* Relevance of a resistance with a coefficient, in use: mu_r/mu, fraction of the largest moment of
   friction, R* mu F_n (Ai, Chen, Rotter, Ooi 2011). settings: NULL, or begin with mu_r. */
static inline int dem_rolling_relevance(const void *settings, const struct dem_regime *g,
                                        struct dem_relevance *v)
{
    v->fraction = settings && g->friction > 0.0 ? *(const double *)settings/g->friction : 0.0;
    v->quantity =
        g->friction > 0.0
            ? "of the moment of friction resists rolling (Ai, Chen, Rotter, Ooi 2011)"
            : "of the moment of friction: there is no friction (Ai, Chen, Rotter, Ooi 2011)";
    return settings != NULL;
}

/* dem_effect.energy */
static inline void dem_rolling_energy(const void *of, const struct dem_contact_batch *restrict b,
                                      double *const *before, double *const *history,
                                      struct dem_energy *restrict e)
{
    (void)of, (void)before, (void)history;
    for (int c = 0; c < b->n; c++)
    {
        const double power = -(e->mx[c]*b->wx[c] + e->my[c]*b->wy[c] + e->mz[c]*b->wz[c]);
        const double square = e->mx[c]*e->mx[c] + e->my[c]*e->my[c] + e->mz[c]*e->mz[c];

        e->lost[c] = b->touching[c]*(power - 0.5*b->dt*square/e->inertia[c])*b->dt;
    }
}

#endif
