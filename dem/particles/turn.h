/*
 * turn.h -- the orientation of a sphere after a drift (orientation.c has the formula). Devices compile
 * it, too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/device.h"

/* tan x/x, from s = x^2 */
DEM_MATH double dem_tangent_series(double s)
{
    return 1.0 + s*(1.0/3.0 + s*(2.0/15.0 + s*(17.0/315.0 + s*(62.0/2835.0 + s*(1382.0/155925.0)))));
}

/* Turn a unit quaternion by the spin times twice `half_dt` [s]. */
DEM_MATH void dem_turn(double wx, double wy, double wz, double half_dt, double q[4])
{
    const double ux = half_dt*wx, uy = half_dt*wy, uz = half_dt*wz, s = ux*ux + uy*uy + uz*uz;
    const double t = dem_tangent_series(s), bx = t*ux, by = t*uy, bz = t*uz;
    const double a = q[0] - bx*q[1] - by*q[2] - bz*q[3];
    const double b = q[1] + bx*q[0] + by*q[3] - bz*q[2];
    const double c = q[2] - bx*q[3] + by*q[0] + bz*q[1];
    const double d = q[3] + bx*q[2] - by*q[1] + bz*q[0];
    const double scale = 1.0/sqrt(a*a + b*b + c*c + d*d);

    q[0] = scale*a;
    q[1] = scale*b;
    q[2] = scale*c;
    q[3] = scale*d;
}
