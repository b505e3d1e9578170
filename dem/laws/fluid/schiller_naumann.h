/*
 * schiller_naumann.h -- row function of schiller_naumann.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/fluid/drag.h"

DEM_MATH void dem_schiller_naumann_row(const void *none, struct dem_body_row *r)
{
    (void)none;
    dem_drag_add(r, dem_drag_single_sphere(dem_drag_reynolds(r, 1.0)));
}
