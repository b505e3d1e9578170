/*
 * dry.h -- dashpot force of one contact, the row function of dry.c, which has the formula and its
 * source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/contact/restitution.h"

struct dem_dry
{
    double restitution;
    int attraction;
    double alpha;    /* 1  derived */
};

DEM_MATH void dem_dry_row(const struct dem_dry *l, struct dem_contact_row *r, double *history)
{
    (void)history;
    dem_dashpot_row(r, l->alpha*sqrt(r->reduced_mass*r->kn), l->attraction);
}

DEM_MATH void dem_dry_energy_row(const struct dem_dry *l, const struct dem_contact_row *r,
    const double *before, const double *after, struct dem_energy_row *e)
{
    (void)l, (void)before, (void)after;
    dem_restitution_energy(r, e);
}
