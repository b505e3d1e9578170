/*
 * saffman_mei.h -- row function of saffman_mei.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/fluid/slip.h"

/* J, the correction of Mei; k: d |o|/(2 |w|) */
DEM_MATH double dem_saffman_mei_correction(double k, double re)
{
    const double root = 0.3314*sqrt(k), decay = dem_exp(-0.1*re);

    return dem_select(re <= 40.0, (1.0 - root)*decay + root, 0.0524*sqrt(k*re));
}

DEM_MATH void dem_saffman_mei_row(const void *none, struct dem_body_row *r)
{
    const struct dem_slip w = dem_slip_of(r);
    const double o[3] = {r->ox, r->oy, r->oz}, d = 2.0*r->radius;
    const double vorticity = sqrt(o[0]*o[0] + o[1]*o[1] + o[2]*o[2]);
    /* below, the force is 0: it is proportional to the product */
    const double acts = dem_select(vorticity*w.size > 1e-60, 1.0, 0.0);
    const double k = acts*0.5*d*vorticity/dem_select(acts > 0.0, w.size, 1.0);
    const double J = dem_saffman_mei_correction(k, w.re);

    (void)none;
    dem_slip_lift(r, &w,
                  acts*1.615*r->density*d*d*
                      sqrt(w.nu/dem_select(acts > 0.0, vorticity, 1.0))*J,
                  o);
}
