/*
 * ergun.h -- row function of ergun.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/fluid/drag.h"

DEM_MATH void dem_ergun_row(const void *none, struct dem_body_row *r)
{
    const double e = dem_drag_void_fraction(r->void_fraction), re = dem_drag_reynolds(r, e);

    (void)none;
    dem_drag_add(r, dem_drag_ergun(e, re));
}
