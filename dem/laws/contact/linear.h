/*
 * linear.h -- friction of one contact, the row function of linear.c, which has the formula and its
 * source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/contact/friction.h"

struct dem_linear
{
    struct dem_friction_settings common;
    double stiffness, ratio;
};

enum
{
    dem_linear_columns = 3
};

/* k_t [N/m] */
DEM_MATH double dem_linear_stiffness(const struct dem_linear *l, const struct dem_contact_row *r)
{
    return l->stiffness*r->touching + l->ratio*r->kn;
}

DEM_MATH void dem_linear_row(const struct dem_linear *l, struct dem_contact_row *r, double *xi)
{
    r->kt = dem_linear_stiffness(l, r);
    dem_friction_row(&l->common, r, xi);
}

DEM_MATH void dem_linear_energy_row(const struct dem_linear *l, const struct dem_contact_row *r,
    const double *before, const double *after, struct dem_energy_row *e)
{
    (void)after;
    dem_friction_energy(&l->common, r, before,
                        dem_select(e->previous_overlap > 0.0, l->stiffness, 0.0) + l->ratio*e->previous_kn, e);
}
