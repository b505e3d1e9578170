/*
 * dry.h -- the law of dry.c for one contact row.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_DRY_H
#define DEM_EFFECTS_DRY_H

#include "effects/contact/restitution.h"
#include "effects/row.h"
#include <math.h>

struct dem_dry
{
    double restitution;
    int attraction;
    double alpha;                                         /* 1    derived */
};

/* min_force: of dem_attraction_min_force */
static inline __attribute__((always_inline)) void dem_dry_row(double alpha, double min_force,
                            struct dem_contact_row *r)
{
    const double eta = alpha*sqrt(r->reduced_mass*r->kn);

    r->eta = eta;
    r->fn = dem_attraction(r->fn, eta*r->vn, min_force);
    r->adhesive_force = dem_attraction_adhesion(r->adhesive_force, min_force);
}

#endif
