/*
 * dry.h -- what dry.c does to one row.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_DRY_H
#define DEM_EFFECTS_DRY_H

#include "effects/restitution.h"
#include "effects/row.h"
#include <math.h>

struct dem_dry
{
    double restitution;
    int attraction;
    double alpha;                                         /* 1    derived */
};

/* `least`: dem_attraction_least */
static inline __attribute__((always_inline)) void dem_dry_row(dem_real alpha, dem_real least, struct dem_row *r)
{
    const dem_real eta = alpha*dem_root(r->reduced_mass*r->kn);

    r->eta = eta;
    r->fn = dem_attraction(r->fn, eta*r->vn, least);
}

#endif
