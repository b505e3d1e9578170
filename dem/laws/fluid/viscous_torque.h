/*
 * viscous_torque.h -- row function of viscous_torque.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/row.h"

struct dem_viscous_torque
{
    int correction;
};

DEM_MATH void dem_viscous_torque_row(const struct dem_viscous_torque *l, struct dem_body_row *r)
{
    const double pi = 3.14159265358979324, d = 2.0*r->radius, mu = r->viscosity;
    const double x = 0.5*r->ox, y = 0.5*r->oy, z = 0.5*r->oz;
    const double dx = x - r->wx, dy = y - r->wy, dz = z - r->wz;
    const double re = dem_select(mu > 0.0,
                                 r->density*d*d*sqrt(dx*dx + dy*dy + dz*dz)/
                                     dem_select(mu > 0.0, mu, 1.0),
                                 0.0);
    const double fit = (128.4 + 12.9*sqrt(re))/(64.0*pi);
    const double t = pi*mu*d*d*d*dem_select(l->correction & (fit > 1.0), fit, 1.0);

    r->spin_drag += t;
    r->spin_drag_wx += t*x;
    r->spin_drag_wy += t*y;
    r->spin_drag_wz += t*z;
}
