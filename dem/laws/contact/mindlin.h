/*
 * mindlin.h -- friction of one contact, the row function of mindlin.c, which has the formula and
 * its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_MINDLIN_H
#define DEM_LAWS_MINDLIN_H

#include "laws/contact/friction.h"
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

/* k_t [N/m] */
DEM_MATH double dem_mindlin_stiffness(const struct dem_mindlin *l, const struct dem_contact_row *r)
{
    return l->modulus*sqrt(r->reduced_radius*r->overlap);
}

DEM_MATH void dem_mindlin_row(const struct dem_mindlin *l, struct dem_contact_row *r, double *xi)
{
    r->kt = dem_mindlin_stiffness(l, r);
    dem_friction_row(&l->common, r, xi);
}

#endif
