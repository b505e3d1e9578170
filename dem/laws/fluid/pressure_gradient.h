/*
 * pressure_gradient.h -- row function of pressure_gradient.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/row.h"

DEM_MATH void dem_pressure_gradient_row(const void *none, struct dem_body_row *r)
{
    (void)none;
    r->fx -= r->volume*r->gx;
    r->fy -= r->volume*r->gy;
    r->fz -= r->volume*r->gz;
}
