/*
 * hooke.h -- normal force of one contact, the row function of hooke.c, which has the formula and
 * its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/contact/impact_spring.h"
#include "laws/energy_row.h"

struct dem_hooke
{
    double stiffness, impact_speed;
    struct dem_impact_spring spring;                      /* derived */
};

/* The force, k_n being known. */
DEM_MATH void dem_hooke_force_row(const struct dem_hooke *l, struct dem_contact_row *r,
                                  double *history)
{
    (void)l, (void)history;
    r->fn += r->kn*r->overlap;
}

DEM_MATH void dem_hooke_row(const struct dem_hooke *l, struct dem_contact_row *r, double *history)
{
    dem_impact_stiffness_row(&l->spring, r);
    dem_hooke_force_row(l, r, history);
}

/* Elastic energy, 1/2 F_n d; k is zero where the bodies are apart. */
DEM_MATH void dem_hooke_energy_row(const struct dem_hooke *l, const struct dem_contact_row *r,
    const double *before, const double *after, struct dem_energy_row *e)
{
    (void)l, (void)before, (void)after;
    e->stored = 0.5*r->kn*r->overlap*r->overlap;
}
