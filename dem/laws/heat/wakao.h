/*
 * wakao.h -- row function of wakao.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/heat/heat_transfer.h"

DEM_MATH void dem_wakao_row(const void *none, struct dem_body_row *r)
{
    const double e = dem_drag_void_fraction(r->void_fraction), re = dem_drag_reynolds(r, e);
    const double prandtl_root = dem_heat_prandtl_root(r);

    (void)none;
    dem_heat_transfer_add(r, 2.0 + 1.1*dem_pow(re, 0.6)*prandtl_root);
}
