/*
 * linear.h -- the law of linear.c on one row.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_LINEAR_H
#define DEM_EFFECTS_LINEAR_H

#include "effects/contact/friction.h"

struct dem_linear
{
    struct dem_friction_settings common;
    double stiffness, ratio;
};

enum
{
    dem_linear_columns = 3
};

DEM_MATH struct dem_slider dem_linear_slider(const struct dem_linear *l,
                                             const struct dem_contact_row *r, const double *xi)
{
    return dem_friction_slider(&l->common, r, l->stiffness*r->touching + l->ratio*r->kn, xi);
}

DEM_MATH void dem_linear_row(const struct dem_linear *l, struct dem_contact_row *r, double *xi)
{
    dem_friction_row(r, dem_linear_slider(l, r, xi), xi);
}

#endif
