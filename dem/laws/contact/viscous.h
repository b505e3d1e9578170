/*
 * viscous.h -- dashpot force of one contact, the row function of viscous.c, which has the formula
 * and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/contact/restitution.h"

struct dem_viscous
{
    double coefficient;
    int attraction;
};

DEM_MATH void dem_viscous_row(const struct dem_viscous *l, struct dem_contact_row *r,
                              double *history)
{
    (void)history;
    dem_dashpot_row(r, l->coefficient*r->touching, l->attraction);
}

DEM_MATH void dem_viscous_energy_row(const struct dem_viscous *l, const struct dem_contact_row *r,
    const double *before, const double *after, struct dem_energy_row *e)
{
    (void)l, (void)before, (void)after;
    dem_restitution_energy(r, e);
}
