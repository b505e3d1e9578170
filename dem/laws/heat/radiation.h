/*
 * radiation.h -- row function of radiation.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/row.h"

struct dem_radiation
{
    double reach, max_temperature;
    double resistance[2];    /* s of i, and of j: their mean; 0 at a wall [1] */
    double wall;             /* 1: the class is one with walls */
};

/* of Stefan and Boltzmann [W/(m2 K4)]; 4 pi */
#define DEM_RADIATION_SIGMA 5.670374419e-8
#define DEM_RADIATION_FOUR_PI 12.5663706143591730

DEM_MATH double dem_radiation_fourth(double T)
{
    return T*T*T*T;
}

DEM_MATH void dem_radiation_row(const struct dem_radiation *l, struct dem_contact_row *r,
                                double *history)
{
    struct dem_contact_scalar *const t = &r->scalars[0];
    const double four_pi = DEM_RADIATION_FOUR_PI;
    const double R = dem_select(r->min_radius > 0.0, r->min_radius, 1.0);
    const double rest = r->distance - r->gap - R, L = dem_select(rest > R, rest, R);
    const double far = l->reach*(R + L), d = dem_select(r->distance > L, r->distance, L);
    const double x = R/d, y = L/d;
    /* A F of the two */
    const double pair = four_pi*R*R*y*y/((1.0 + sqrt(1.0 - x*x))*(1.0 + sqrt(1.0 - y*y)));
    const double plane = 0.5*four_pi*R*R*(1.0 - d/far);
    const double seen = dem_select(l->wall > 0.0, plane, pair);
    const double sees = dem_select(d < far, r->is_primary, 0.0);
    const double resistance = (l->resistance[0]/(R*R) + l->resistance[1]/(L*L))/four_pi +
                              1.0/dem_select(sees > 0.0, seen, 1.0);
    const double heat = sees*DEM_RADIATION_SIGMA*
                        (dem_radiation_fourth(t->j) - dem_radiation_fourth(t->i))/resistance;

    (void)history;
    t->rate_i += heat;
    t->rate_j -= heat;
}
