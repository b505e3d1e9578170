/*
 * virtual_mass.h -- row function of virtual_mass.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/fluid/drag.h"

struct dem_virtual_mass
{
    double coefficient;
    int correlation;
};

enum    /* `swarm` */
{
    DEM_SWARM_NONE,
    DEM_SWARM_ZUBER,
    DEM_SWARM_FELDERHOF
};

/* the added mass a */
DEM_MATH void dem_virtual_mass_prepare_row(const struct dem_virtual_mass *l, struct dem_body_row *r)
{
    const double e = dem_drag_void_fraction(r->void_fraction), s = 1.0 - e,
                 fluid = dem_select(r->density*r->volume > 0.0, 1.0, 0.0);
    const double ratio = dem_select(fluid > 0.0, r->mass, 1.0)/
                         dem_select(fluid > 0.0, r->density*r->volume, 1.0);
    const double L = dem_log(dem_select(ratio > 1e-12, ratio, 1e-12));
    const double zuber = (1.0 + 2.0*s)/e;
    const double felderhof = 1.0 + 2.0*s*(0.047*L + 0.13 - s*(0.066*L + 0.58 - 1.42*s));
    const double factor =
        dem_select(l->correlation == DEM_SWARM_ZUBER, zuber,
                   dem_select(l->correlation == DEM_SWARM_FELDERHOF, felderhof, 1.0));

    r->added_mass +=
        l->coefficient*dem_select(factor > 0.0, factor, 0.0)*r->density*r->volume;
}

/* a Du/Dt */
DEM_MATH void dem_virtual_mass_row(const struct dem_virtual_mass *l, struct dem_body_row *r)
{
    (void)l;
    r->rx += r->added_mass*r->ax;
    r->ry += r->added_mass*r->ay;
    r->rz += r->added_mass*r->az;
}
