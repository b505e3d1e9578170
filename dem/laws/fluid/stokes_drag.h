/*
 * stokes_drag.h -- row function of stokes_drag.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/fluid/drag.h"

DEM_MATH void dem_stokes_drag_row(const void *none, struct dem_body_row *r)
{
    (void)none;
    dem_drag_add(r, 1.0);
}
