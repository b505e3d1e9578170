/*
 * mindlin.h -- friction of one contact, the row function of mindlin.c, which has the formula and
 * its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/contact/friction.h"

struct dem_mindlin
{
    struct dem_friction_settings common;
    double modulus;                                       /* Pa   8 G*, derived */
};

enum
{
    dem_mindlin_columns = 3
};

/* k_t [N/m]; modulus: 8 G* */
DEM_MATH double dem_mindlin_kt(double modulus, const struct dem_contact_row *r)
{
    return modulus*sqrt(r->reduced_radius*r->overlap);
}

DEM_MATH double dem_mindlin_stiffness(const struct dem_mindlin *l, const struct dem_contact_row *r)
{
    return dem_mindlin_kt(l->modulus, r);
}

DEM_MATH void dem_mindlin_row(const struct dem_mindlin *l, struct dem_contact_row *r, double *xi)
{
    r->kt = dem_mindlin_stiffness(l, r);
    dem_friction_row(&l->common, r, xi);
}

DEM_MATH void dem_mindlin_energy_row(const struct dem_mindlin *l, const struct dem_contact_row *r,
    const double *before, const double *after, struct dem_energy_row *e)
{
    (void)after;
    dem_friction_energy(&l->common, r, before,
                        l->modulus*sqrt(r->reduced_radius*e->previous_overlap), e);
}
