/*
 * mindlin.h -- the law of mindlin.c on one row.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_MINDLIN_H
#define DEM_EFFECTS_MINDLIN_H

#include "effects/contact/friction.h"
#include <math.h>

struct dem_mindlin
{
    struct dem_friction_settings common;
    double modulus;                                       /* Pa   8 G*, derived */
};

enum
{
    dem_mindlin_columns = 3
};

/* 8 G* of a class [Pa], for the law of this name; an error without a normal law or shear moduli. */
int dem_mindlin_modulus(const char *law, const struct dem_pair_class *, double *modulus);

DEM_MATH double dem_mindlin_stiffness(double modulus, const struct dem_contact_row *r)
{
    return modulus*sqrt(r->reduced_radius*r->overlap);
}

DEM_MATH struct dem_slider dem_mindlin_slider(const struct dem_mindlin *l,
                                              const struct dem_contact_row *r, const double *xi)
{
    return dem_friction_slider(&l->common, r, dem_mindlin_stiffness(l->modulus, r), xi);
}

DEM_MATH void dem_mindlin_row(const struct dem_mindlin *l, struct dem_contact_row *r, double *xi)
{
    dem_friction_row(r, dem_mindlin_slider(l, r, xi), xi);
}

#endif
