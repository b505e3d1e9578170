/*
 * conduction.h -- row function of conduction.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/row.h"

struct dem_conduction
{
    int area;
    double per_radius;    /* 2 k c  [W/(m K)] */
};

DEM_MATH void dem_conduction_row(const struct dem_conduction *l, struct dem_contact_row *r,
                                 double *history)
{
    struct dem_contact_scalar *const t = &r->scalars[0];
    const double heat =
        r->touching*l->per_radius*sqrt(r->reduced_radius*r->overlap)*(t->j - t->i);

    (void)history;
    t->rate_i += heat;
    t->rate_j -= heat;
}
