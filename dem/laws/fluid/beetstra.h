/*
 * beetstra.h -- row function of beetstra.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/fluid/drag.h"

struct dem_beetstra
{
    double mean_diameter;
    int mean;
};

enum    /* `mean` */
{
    DEM_BEETSTRA_GIVEN,
    DEM_BEETSTRA_AROUND
};

/* F: creeping, then inertial part */
DEM_MATH double dem_beetstra_normalised(double e, double re)
{
    const double s = 1.0 - e, power = dem_pow(re, 0.5*(1.0 + 4.0*s));
    const double ten_to_3s = dem_exp(6.90775527898213705*s);    /* 10^(3 s): 3 ln 10 */
    const double creeping = 10.0*s/(e*e) + e*e*(1.0 + 1.5*sqrt(s));
    const double above = (1.0/e + 3.0*e*s)*re + 8.4*dem_pow(re, 0.657);

    return creeping + 0.413/(24.0*e*e)*above*(power/(power + ten_to_3s));
}

DEM_MATH void dem_beetstra_row(const struct dem_beetstra *l, struct dem_body_row *r)
{
    const double e = dem_drag_void_fraction(r->void_fraction), re = dem_drag_reynolds(r, e);
    const double mean =
        dem_select(l->mean == DEM_BEETSTRA_AROUND, r->mean_diameter, l->mean_diameter);
    const double y = dem_select(mean > 0.0, 2.0*r->radius/dem_select(mean > 0.0, mean, 1.0), 1.0);

    dem_drag_add(r, y*e*dem_beetstra_normalised(e, re/dem_select(y > 0.0, y, 1.0)));
}
