/*
 * ranz_marshall.h -- row function of ranz_marshall.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/heat/heat_transfer.h"

DEM_MATH void dem_ranz_marshall_row(const void *none, struct dem_body_row *r)
{
    const double re = dem_drag_reynolds(r, 1.0);

    (void)none;
    dem_heat_transfer_add(r, 2.0 + 0.6*sqrt(re)*dem_heat_prandtl_root(r));
}
