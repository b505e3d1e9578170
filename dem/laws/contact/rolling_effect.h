/*
 * rolling_effect.h -- what the descriptors of rolling resistances share: relevance.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

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
