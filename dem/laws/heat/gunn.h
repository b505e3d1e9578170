/*
 * gunn.h -- row function of gunn.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/heat/heat_transfer.h"

DEM_MATH void dem_gunn_row(const void *none, struct dem_body_row *r)
{
    const double e = dem_drag_void_fraction(r->void_fraction), re = dem_drag_reynolds(r, e);
    const double prandtl_root = dem_heat_prandtl_root(r);
    const double film = (7.0 - 10.0*e + 5.0*e*e)*(1.0 + 0.7*dem_pow(re, 0.2)*prandtl_root);

    (void)none;
    dem_heat_transfer_add(r,
                          film + (1.33 - 2.4*e + 1.2*e*e)*dem_pow(re, 0.7)*prandtl_root);
}
