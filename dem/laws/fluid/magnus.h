/*
 * magnus.h -- row function of magnus.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/fluid/slip.h"

/* tanh x = 1 - 2/(e^2x + 1); for |x| > 30 it is 1 in double precision */
DEM_MATH double dem_magnus_tanh(double x)
{
    const double size = dem_select(fabs(x) > 30.0, 30.0, fabs(x)), expm1_2x = dem_expm1(2.0*size),
                 y = expm1_2x/(expm1_2x + 2.0);

    return dem_select(x < 0.0, -y, y);
}

/* C; S = d |W|/|w| */
DEM_MATH double dem_magnus_coefficient(double S, double re)
{
    return 1.0 - (0.675 + 0.15*(1.0 + dem_magnus_tanh(0.28*(S - 2.0))))*
                     dem_magnus_tanh(0.18*sqrt(re));
}

DEM_MATH void dem_magnus_row(const void *none, struct dem_body_row *r)
{
    const double eighth_pi = 0.39269908169872415, d = 2.0*r->radius;
    const struct dem_slip w = dem_slip_of(r);
    const double spin[3] = {r->wx, r->wy, r->wz};
    const double spin_rate = sqrt(spin[0]*spin[0] + spin[1]*spin[1] + spin[2]*spin[2]);
    const double S = dem_select(w.size > 1e-60,
                                d*spin_rate/dem_select(w.size > 1e-60, w.size, 1.0), 0.0);
    const double C = dem_magnus_coefficient(S, w.re);

    (void)none;
    dem_slip_lift(r, &w, eighth_pi*r->density*d*d*d*C, spin);
}
