/*
 * mindlin_incremental.h -- row function of mindlin_incremental.c, which has the formula and source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_MINDLIN_INCREMENTAL_H
#define DEM_LAWS_MINDLIN_INCREMENTAL_H

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

#endif
