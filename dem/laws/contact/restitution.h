/*
 * restitution.h -- dashpot coefficient for a given coefficient of restitution.
 *
 *   eta = alpha sqrt(m* k_n),    alpha = sqrt(2 (p + 1)) * L/sqrt(pi^2 + L^2),    L = -ln e
 *
 *   eta  force per normal relative velocity                        [kg/s]
 *   m*   reduced mass                                              [kg]
 *   k_n  secant stiffness of the normal law F = k_n d ~ d^p        [N/m]
 *   p    exponent of the normal law: 1 linear, 3/2 Hertz           [1]
 *
 * With a dashpot ~ d^((p-1)/2) a change of variables turns the equation of motion into the linear
 * one, so e does not depend on the impact speed and alpha is exact: p = 1 gives the textbook value
 * 2 L/sqrt(pi^2 + L^2), p = 3/2 the sqrt(5) L/sqrt(pi^2 + L^2) of Hu et al. L/sqrt(pi^2 + L^2) is 0
 * for e = 1, and 1 (critical damping) for e = 0. Both hold if the force may be attractive at the
 * end of the contact; clamped at zero, restitution is higher. A spring that is itself attractive
 * (adhesion) is never clamped.
 *
 * Source: Antypov and Elliott, EPL 94 (2011) 50004; Hu, Hu, Jian, Liu, Wan, J. Computers 6, no. 5
 * (2011).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/energy_row.h"

#define DEM_RESTITUTION_PI2 9.86960440108935862           /* pi^2 */

/* ---- attraction at the end of a contact: the dashpot pulls harder than the spring repels --------- */

enum    /* lower limit of the normal force */
{
    DEM_ATTRACTION_ALLOWED,    /* none */
    DEM_ATTRACTION_CLAMPED,    /* 0 where the spring repels, none where it attracts */
    DEM_ATTRACTION_NONE        /* 0; no adhesive force counts in the friction limit either */
};

/* The damping force joins the spring force of the row. With DEM_ATTRACTION_NONE the force is
   max(F, 0), eq. (10) of Open DEM Japan, Hooke/Hysteresis normal contact model (in Japanese, 2025).
   Masks instead of branches: the loop over rows stays vector code. */
DEM_MATH void dem_damping_row(struct dem_contact_row *r, double eta, double damping, int attraction)
{
    const double force = r->fn - damping;
    const int clamped = (attraction == DEM_ATTRACTION_CLAMPED) & (r->fn >= 0.0),
              none = attraction == DEM_ATTRACTION_NONE;

    r->eta = eta;
    r->fn = dem_select((clamped | none) & (force < 0.0), 0.0, force);
    r->adhesive_force = dem_select(none, 0.0, r->adhesive_force);
}

/* A dashpot on the velocity of half a step ago. */
DEM_MATH void dem_dashpot_row(struct dem_contact_row *r, double eta, int attraction)
{
    dem_damping_row(r, eta, eta*r->vn, attraction);
}

/* A dashpot on the velocity in the middle of the kick, as far as this contact alone changes it:

     F = F_s - eta (v_n + a F),  a = dt/(2 m*),  so  F = F_s - eta (v_n + a F_s)/(1 + a eta)

   Of second order in the step, and stable with any eta. With the velocity before the kick an impact
   of 20 steps that returns 0.17 of its speed would return 6 % less, one that returns 0.05 20 %. */
DEM_MATH void dem_centred_dashpot_row(struct dem_contact_row *r, double eta, int attraction)
{
    const double mass = r->reduced_mass,
                 a = dem_select(mass > 0.0, 0.5*r->dt/dem_select(mass > 0.0, mass, 1.0), 0.0);

    dem_damping_row(r, eta, eta*(r->vn + a*r->fn)/(1.0 + a*eta), attraction);
}

/* Dissipated by the dashpot: its force, clamped or not, times the velocity in the middle of the kick,
   as far as this contact alone changes it: eta v_n (v_n + F_n dt/2 m*) dt. With v_n before the kick
   instead, an impact with e = 0.9 and 20 steps would count 0.5 % too much. */
DEM_MATH void dem_restitution_energy(const struct dem_contact_row *r, struct dem_energy_row *e)
{
    const double mass = r->reduced_mass,
                 gain = dem_select(mass > 0, r->dt/2/dem_select(mass > 0, mass, 1), 0);

    e->lost = -r->touching*e->normal_force*(r->vn + gain*r->fn)*r->dt;
}
