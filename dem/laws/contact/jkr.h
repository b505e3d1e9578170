/*
 * jkr.h -- row functions of jkr.c, which has the formula: the adhesive force that friction needs,
 * and the force of one contact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/energy_row.h"

struct dem_jkr
{
    double work;
    double scale;  /* m    pi w/(8 E*): a_t^3 = this R*^2; derived */
};

enum
{
    dem_jkr_columns = 1    /* 1 while the row adheres */
};

/* N/m: pi w */
DEM_MATH double dem_jkr_pull(const struct dem_jkr *l)
{
    return l->work*3.14159265358979324;
}

/* Scratch column: x of an adhering row, or 0. */
DEM_MATH void dem_jkr_adhesion_row(const struct dem_jkr *l, struct dem_contact_row *r,
                                   double *adheres)
{
    const double third = 1.0/3.0;
    const double R = r->reduced_radius, a = dem_pow(l->scale*R*R, third),
                 length = a*a/dem_select(R > 0.0, R, 1.0);
    const double raw = -r->gap/dem_select(length > 0.0, length, 1.0),
                 D = dem_select(raw > -3.0, raw, -3.0);

    /* adhesion begins at contact and ends with the tail */
    const double still = dem_select(raw > -3.0, adheres[0], 0.0),
                 bare = dem_select(r->bond_replaces > 0.0, 0.0, 1.0);
    const double now =
        dem_select(r->touching > 0.0, 1.0, still)*dem_select(length > 0.0, bare, 0.0);

    const double B = D*(4.0/3.0), radicand = 64.0 + B*B*B,
                 A = dem_pow(8.0 + sqrt(dem_select(radicand > 0.0, radicand, 0.0)), third);
    const double s = 16.0/(A*A + B + B*B/(A*A)), p = sqrt(s), discriminant = 8.0/p - s;
    const double x = 0.5*(p + sqrt(dem_select(discriminant > 0.0, discriminant, 0.0))),
                 x3 = x*x*x;

    r->scratch = now*x;
    r->adhesive_force = now*(dem_jkr_pull(l)*R*(x3/6.0*(x3 - 6.0) + 3.0) - r->kn*r->overlap);
}

DEM_MATH void dem_jkr_row(const struct dem_jkr *l, struct dem_contact_row *r, double *adheres)
{
    /* a bond may have been made after the adhesive force was set */
    const double bare = dem_select(r->bond_replaces > 0.0, 0.0, 1.0), before = adheres[0],
                 now = dem_select(r->scratch > 0.0, bare, 0.0);
    const double pull = dem_jkr_pull(l), R = r->reduced_radius,
                 a = dem_pow(l->scale*R*R, 1.0/3.0), x = r->scratch, x3 = x*x*x, x4 = x3*x;
    const double hertz = r->kn*r->overlap;

    /* the unit of energy, E a_t^5/R^2 with reduced quantities, is (pi w/8) a_t^2 */
    const double energy = pull/8.0*a*a*x4*(8.0 + x3*(x3*(8.0/15.0) - 16.0/3.0));
    /* x = 1; x^3 = 4: 4.8 x^4 */
    const double pull_off = pull/8.0*a*a*3.2, snap_in = pull/8.0*a*a*30.4780;
    const double left = dem_select(bare > 0.0, pull_off, energy - 0.4*hertz*r->overlap);

    r->fn += now*(pull*R/6.0*x3*(x3 - 6.0) - hertz);
    r->stored += now*energy;
    r->lost += dem_select(now > before, snap_in, dem_select(now < before, left, 0.0));
    adheres[0] = now;
}

/* The row has stored the energy of the whole law; hertz counts 2/5 F_n d of it already. */
DEM_MATH void dem_jkr_energy_row(const struct dem_jkr *l, const struct dem_contact_row *r,
    const double *before, const double *after, struct dem_energy_row *e)
{
    (void)l, (void)before;
    e->stored -= after[0]*0.4*r->kn*r->overlap*r->overlap;
}
