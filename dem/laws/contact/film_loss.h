/*
 * film_loss.h -- fraction of the rebound speed that is lost in the fluid film; decides whether a
 * scene needs stokesDamping or lubrication.
 *
 *   1 - exp(-35/St*),   St* = St (1 + rho_f/(2 rho_p)),   St = m* v/(6 pi mu R*^2)
 *
 *   St   Stokes number of an impact at the impactSpeed of the normal law      [1]
 *   St*  the same with the added mass of an isolated sphere          [1]
 *
 * Source: Legendre, Zenit, Daniel, Guiraud, Chem. Eng. Sci. 61 (2006) 3543.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_numbers.h"

#include <math.h>

/* Returns 0 without a Stokes number. */
static inline int dem_film_loss(const struct dem_regime *g, struct dem_relevance *v)
{
    if (g->stokes > 0.0)
    {
        const double added = 0.5*g->suspension.fluid_density/g->suspension.density;

        v->fraction = 1.0 - exp(-35.0/(g->stokes*(1.0 + added)));
    }
    else
    {
        v->fraction = 0.0;
    }
    v->quantity = "of the rebound speed is lost in the fluid film (Legendre et al. 2006)";
    return g->stokes > 0.0;
}
