/*
 * koch_hill.h -- row function of koch_hill.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/fluid/drag.h"

/* F0; the denominator of the dilute form is positive for s = 0 to 0.8, with a minimum of 0.1 at
   0.65 */
DEM_MATH double dem_koch_hill_creeping(double e, double s)
{
    const double logarithm = dem_log(dem_select(s > 0.0, s, 1.0));    /* s ln s is 0 at s = 0 */
    const double dilute = (1.0 + 3.0*sqrt(0.5*s) + 135.0/64.0*s*logarithm + 16.14*s)
                        / (1.0 + s*(0.681 + s*(8.16*s - 8.48)));

    return dem_select(s < 0.4, dilute, 10.0*s/(e*e*e));
}

/* F3 */
DEM_MATH double dem_koch_hill_inertial(double e, double s)
{
    return 0.0673 + 0.212*s + 0.0232/(e*e*e*e*e);
}

/* F0, and half of F3 */
DEM_MATH void dem_koch_hill_prepare_row(const void *none, struct dem_body_row *r)
{
    const double e = dem_drag_void_fraction(r->void_fraction), s = 1.0 - e;

    (void)none;
    r->voidage_factor[0] = dem_koch_hill_creeping(e, s);
    r->voidage_factor[1] = 0.5*dem_koch_hill_inertial(e, s);
}

DEM_MATH void dem_koch_hill_row(const void *none, struct dem_body_row *r)
{
    const double e = dem_drag_void_fraction(r->void_fraction), re = dem_drag_reynolds(r, e);

    (void)none;
    dem_drag_add(r, e*e*(r->voidage_factor[0] + r->voidage_factor[1]*re));
}
