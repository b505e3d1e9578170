/*
 * slip.h -- slip between fluid and particle of a row, for the lift laws.
 *
 *   w = u - v,   Re_p = rho d |w|/mu
 *
 *   u, v   fluid (interstitial) and particle velocity              [m/s]
 *
 * Re_p contains the interstitial slip: the lift laws are for a single sphere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/row.h"

struct dem_slip
{
    double x, y, z, size;                                 /* m/s */
    double re, nu;                                        /* 1, m2/s; 0 where there is no fluid */
};

DEM_MATH struct dem_slip dem_slip_of(const struct dem_body_row *r)
{
    struct dem_slip s = {.x = r->ux - r->vx, .y = r->uy - r->vy, .z = r->uz - r->vz};
    const double rho = r->density, mu = r->viscosity, fluid = dem_select(rho*mu > 0.0, 1.0, 0.0);

    s.size = sqrt(s.x*s.x + s.y*s.y + s.z*s.z);
    s.nu = fluid*mu/dem_select(fluid > 0.0, rho, 1.0);
    s.re = fluid*(2.0*r->radius)*s.size/dem_select(fluid > 0.0, s.nu, 1.0);
    return s;
}

/* adds k w x a to the force whose opposite acts on the fluid */
DEM_MATH void dem_slip_lift(struct dem_body_row *r, const struct dem_slip *w, double k,
                            const double a[3])
{
    r->rx += k*(w->y*a[2] - w->z*a[1]);
    r->ry += k*(w->z*a[0] - w->x*a[2]);
    r->rz += k*(w->x*a[1] - w->y*a[0]);
}
