/*
 * friction_heat.h -- row function of friction_heat.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/row.h"

struct dem_friction_heat
{
    double wall_fraction;
    double fraction;    /* of the particle i [1] */
};

DEM_MATH void dem_friction_heat_row(const struct dem_friction_heat *l, struct dem_contact_row *r,
                                    double *history)
{
    struct dem_contact_scalar *const t = &r->scalars[0];
    const double heat = dem_select(r->dt > 0.0, r->inverse_dt, 0.0)*r->dissipated;

    (void)history;
    t->rate_i += l->fraction*heat;
    t->rate_j += (1.0 - l->fraction)*heat;    /* a wall's is not used */
}
