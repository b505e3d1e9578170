/*
 * stokes_damping.h -- dashpot force of one contact, the row function of stokes_damping.c, which has
 * the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/contact/restitution.h"

struct dem_stokes_damping
{
    double restitution;
    double beta;
    double viscosity;
    double added_mass;
    double fluid_density;
    double density;    /* kg/m3  rho_f used, derived */
    int speed, attraction;
    double critical;   /* 1    alpha at critical damping, derived */
    double loss;       /* 1    -ln e_max, derived */
    double more_mass;  /* 1    m* with added mass over m*, derived */
};

enum    /* v in St */
{
    DEM_STOKES_IMPACT,
    DEM_STOKES_INSTANTANEOUS
};

enum
{
    dem_stokes_damping_columns = 1    /* v, 0 in the first step of a contact */
};

DEM_MATH void dem_stokes_damping_row(const struct dem_stokes_damping *l, struct dem_contact_row *r,
                             double *impact_speed)
{
    const double six_pi = 18.8495559215387594, pi2 = DEM_RESTITUTION_PI2;
    /* m/s: stands for a stored speed of zero */
    const double at_rest = 1e-30;
    const int keep = l->speed == DEM_STOKES_IMPACT;
    const double R = r->reduced_radius, m = r->reduced_mass, before = impact_speed[0];
    const double mu = dem_select(l->viscosity > 0.0, l->viscosity, r->viscosity);

    const double now = dem_select(fabs(r->vn) > at_rest, fabs(r->vn), at_rest);
    const double kept = dem_select(before > 0.0, before, now);
    const double speed = dem_select(r->touching > 0.0, dem_select(keep, kept, now), 0.0);

    /* instantaneous: St is negative while the surfaces separate, as in LIGGGHTS */
    const double S = l->more_mass*m*speed, D = l->beta*(six_pi*mu*R*R);
    const double T = dem_select(keep | (r->vn < 0.0), l->loss*S + D, fabs(l->loss*S - D));
    const double size = sqrt(pi2*S*S + T*T);

    impact_speed[0] = speed;
    dem_centred_dashpot_row(
        r, l->critical*(T/dem_select(size > 0.0, size, 1.0))*sqrt(m*r->kn), l->attraction);
}

DEM_MATH void dem_stokes_damping_energy_row(const struct dem_stokes_damping *l, const struct dem_contact_row *r,
    const double *before, const double *after, struct dem_energy_row *e)
{
    (void)l, (void)before, (void)after;
    dem_restitution_energy(r, e);
}
