/*
 * hoelzer_sommerfeld.h -- row function of hoelzer_sommerfeld.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/fluid/drag.h"

/* An empty row of a batch counts as a sphere. */
DEM_MATH double dem_hoelzer_sommerfeld_form(double sphericity)
{
    return dem_select(sphericity > 0.0, sphericity, 1.0);
}

/* Cd Re/24 of a single particle */
DEM_MATH double dem_hoelzer_sommerfeld_single(const struct dem_body_row *r, double re)
{
    const double phi = dem_hoelzer_sommerfeld_form(r->sphericity), root = sqrt(phi);
    const double flat = -dem_log10(dem_select(phi < 1.0, phi, 1.0));
    const double power = dem_select(flat > 0.0, dem_pow(dem_select(flat > 0.0, flat, 1.0), 0.2), 0.0);
    const double ten_to_power = dem_exp(2.30258509299404568*0.4*power);    /* ln 10 */

    return (8.0/sqrt(dem_hoelzer_sommerfeld_form(r->lengthwise)) + 16.0/root + 3.0*sqrt(re)/(root*sqrt(root)) +
            0.42*ten_to_power*re/dem_hoelzer_sommerfeld_form(r->crosswise))/24.0;
}

DEM_MATH void dem_hoelzer_sommerfeld_row(const void *none, struct dem_body_row *r)
{
    const double e = dem_drag_void_fraction(r->void_fraction), re = dem_drag_reynolds(r, e);
    const double chi = 3.7 - 0.65*dem_drag_transition(re);

    (void)none;
    dem_drag_add(r, dem_hoelzer_sommerfeld_single(r, re)*dem_pow(e, 1.0 - chi));
}
