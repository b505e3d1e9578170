/*
 * hertz.h -- the law of hertz.c for one contact row.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_HERTZ_H
#define DEM_EFFECTS_HERTZ_H

#include "core/math.h"
#include "effects/row.h"
#include <math.h>

struct dem_hertz
{
    double impact_speed;
    double stiffness;
    double modulus;  /* Pa   4/3 E* or the stiffness, derived */
};

static inline __attribute__((always_inline)) void dem_hertz_row(double modulus,
                            struct dem_contact_row *r)
{
    const double kn = modulus*sqrt(r->reduced_radius*r->overlap);

    r->kn = kn;
    r->fn += kn*r->overlap;
}

#endif
