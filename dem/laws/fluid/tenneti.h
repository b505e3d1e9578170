/*
 * tenneti.h -- row function of tenneti.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/fluid/drag.h"

/* e^2 F without the single-sphere term F1/e: the constant, and the factor of Re */
DEM_MATH void dem_tenneti_prepare_row(const void *none, struct dem_body_row *r)
{
    const double e = dem_drag_void_fraction(r->void_fraction), s = 1.0 - e, s3 = s*s*s;

    (void)none;
    r->voidage_factor[0] = 5.81*s/e + 0.48*dem_pow(s, 1.0/3.0)/(e*e);
    r->voidage_factor[1] = s3*(0.95*e*e + 0.61*s3);
}

DEM_MATH void dem_tenneti_row(const void *none, struct dem_body_row *r)
{
    const double e = dem_drag_void_fraction(r->void_fraction), re = dem_drag_reynolds(r, e);

    (void)none;
    dem_drag_add(r, dem_drag_single_sphere(re)/e + r->voidage_factor[0] + r->voidage_factor[1]*re);
}
