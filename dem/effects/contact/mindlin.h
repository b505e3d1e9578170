/*
 * mindlin.h -- the stiffness of mindlin.c for one contact row.
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

/* 8 G* of a class [Pa], for the law of this name; an error without a normal law or shear moduli. */
int dem_mindlin_modulus(const char *law, const struct dem_pair_class *, double *modulus);

static inline __attribute__((always_inline)) double dem_mindlin_stiffness(double modulus,
                            const struct dem_contact_row *r)
{
    return modulus*sqrt(r->reduced_radius*r->overlap);
}

#endif
