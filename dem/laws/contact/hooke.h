/*
 * hooke.h -- normal force of one contact, the row function of hooke.c, which has the formula and
 * its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_HOOKE_H
#define DEM_LAWS_HOOKE_H

#include "laws/contact/impact_speed.h"
#include "laws/row.h"

struct dem_hooke
{
    double stiffness, impact_speed;
    struct dem_impact_spring spring;                      /* derived */
};

enum
{
    dem_hooke_columns = 0
};

/* before the rows */
DEM_MATH void dem_hooke_before(const struct dem_hooke *l, struct dem_contact_batch *b)
{
    dem_impact_stiffness(&l->spring, b);
}

/* k_n: of dem_hooke_before */
DEM_MATH void dem_hooke_row(const struct dem_hooke *l, struct dem_contact_row *r, double *history)
{
    (void)l, (void)history;
    r->fn += r->kn*r->overlap;
}

#endif
