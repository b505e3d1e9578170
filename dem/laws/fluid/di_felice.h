/*
 * di_felice.h -- row function of di_felice.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/fluid/drag.h"

DEM_MATH void dem_di_felice_row(const void *none, struct dem_body_row *r)
{
    const double e = dem_drag_void_fraction(r->void_fraction), re = dem_drag_reynolds(r, e);
    const double chi = 3.7 - 0.65*dem_drag_transition(re);

    (void)none;
    dem_drag_add(r, dem_drag_dallavalle(re)*dem_pow(e, 1.0 - chi));
}
