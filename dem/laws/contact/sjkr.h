/*
 * sjkr.h -- row function of sjkr.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/energy_row.h"

struct dem_sjkr
{
    double density;
};

DEM_MATH void dem_sjkr_row(const struct dem_sjkr *l, struct dem_contact_row *r, double *history)
{
    const double scale = 6.28318530717958648*l->density;

    (void)history;
    r->fn -= scale*r->reduced_radius*dem_select(r->bond_replaces > 0.0, 0.0, r->overlap);
}

/* Energy needed to separate the surfaces; dissipated when a bond replaces the contact. */
DEM_MATH void dem_sjkr_energy_row(const struct dem_sjkr *l, const struct dem_contact_row *r,
    const double *before, const double *after, struct dem_energy_row *e)
{
    const double scale = 6.28318530717958648*l->density,
                 held = -0.5*scale*r->reduced_radius*r->overlap*r->overlap;

    (void)before, (void)after;
    e->stored = r->bond_replaces > 0.0 ? 0.0 : held;
    e->lost = r->bond_replaces > 1.0 ? held : 0.0;
}
