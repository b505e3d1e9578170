/*
 * hertz.h -- normal force of one contact, the row function of hertz.c, which has the formula and
 * its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/energy_row.h"

struct dem_hertz
{
    double impact_speed;
    double stiffness;
    double modulus;  /* Pa   4/3 E* or the stiffness, derived */
};

DEM_MATH void dem_hertz_row(const struct dem_hertz *l, struct dem_contact_row *r, double *history)
{
    (void)history;
    r->kn = l->modulus*sqrt(r->reduced_radius*r->overlap);
    r->fn += r->kn*r->overlap;
}

/* Elastic energy, 2/5 F_n d. */
DEM_MATH void dem_hertz_energy_row(const struct dem_hertz *l, const struct dem_contact_row *r,
    const double *before, const double *after, struct dem_energy_row *e)
{
    (void)l, (void)before, (void)after;
    e->stored = r->touching*0.4*r->kn*r->overlap*r->overlap;
}
