/*
 * sjkr.h -- row function of sjkr.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_SJKR_H
#define DEM_LAWS_SJKR_H

#include "laws/row.h"

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

#endif
