/*
 * mindlin_incremental.h -- row function of mindlin_incremental.c, which has the formula and source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/contact/mindlin.h"

struct dem_mindlin_incremental
{
    struct dem_friction_settings common;
    double modulus;    /* Pa   8 G*, derived */
};

enum
{
    dem_mindlin_incremental_columns = 4    /* spring, k_t */
};

DEM_MATH void dem_mindlin_incremental_row(const struct dem_mindlin_incremental *l,
                                          struct dem_contact_row *r, double *h)
{
    r->kt = dem_mindlin_kt(l->modulus, r);

    const double keep = dem_friction_keep(h[3], r->kt);

    h[0] *= keep;
    h[1] *= keep;
    h[2] *= keep;
    dem_friction_row(&l->common, r, h);
    h[3] = r->kt;
}

/* A spring that is shortened to keep its force while k grows to k' loses k xi^2/2 (1 - k/k'). */
DEM_MATH void dem_mindlin_incremental_energy_row(const struct dem_mindlin_incremental *l, const struct dem_contact_row *r,
    const double *before, const double *after, struct dem_energy_row *e)
{
    const double was = before[3],
                 grown = r->touching*dem_select(was < r->kt, r->kt - was, 0.0);
    const double keep = dem_select(grown > 0.0, dem_friction_keep(was, r->kt), 1.0);
    const double square = before[0]*before[0] + before[1]*before[1] + before[2]*before[2];
    const double xi[3] = {keep*before[0], keep*before[1], keep*before[2]};

    (void)after;
    dem_friction_energy(&l->common, r, xi, was + grown, e);
    e->lost += was/2*square*(1.0 - keep);
}
