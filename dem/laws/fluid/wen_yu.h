/*
 * wen_yu.h -- row function of wen_yu.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/fluid/drag.h"

DEM_MATH void dem_wen_yu_prepare_row(const void *none, struct dem_body_row *r)
{
    (void)none;
    r->voidage_factor[0] = dem_drag_voidage_factor(dem_drag_void_fraction(r->void_fraction));
    r->voidage_factor[1] = 0.0;    /* not used */
}

DEM_MATH void dem_wen_yu_row(const void *none, struct dem_body_row *r)
{
    const double e = dem_drag_void_fraction(r->void_fraction), re = dem_drag_reynolds(r, e);

    (void)none;
    dem_drag_add(r, r->voidage_factor[0]*dem_drag_single_sphere(re));
}
