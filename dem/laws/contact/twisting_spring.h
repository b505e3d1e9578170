/*
 * twisting_spring.h -- row function of twisting_spring.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/energy_row.h"

struct dem_twisting_spring
{
    double friction;
    int lever;
    double damping;
    double ratio;                                         /* 1    k_w per k_n a^2, derived */
};

enum    /* `lever`: largest moment over mu F_n */
{
    DEM_TWISTING_CONTACT,
    DEM_TWISTING_REDUCED
};

enum
{
    dem_twisting_spring_columns = 1    /* twist */
};

DEM_MATH void dem_twisting_spring_row(const struct dem_twisting_spring *l,
                                      struct dem_contact_row *r, double *twist)
{
    /* 3 pi/16 */
    const double by_contact =
        dem_select(l->lever == DEM_TWISTING_CONTACT, 0.58904862254808623, 0.0);
    const double by_radius = dem_select(l->lever == DEM_TWISTING_REDUCED, 1.0, 0.0);
    const double R = r->reduced_radius, a2 = R*r->overlap;
    const double lever = by_contact*sqrt(a2) + by_radius*R;
    const double stiffness = l->ratio*r->kn*a2;
    const double damping = 2.0*l->damping*R*sqrt(0.4*r->reduced_mass*stiffness);
    const double rate = r->wx*r->hx + r->wy*r->hy + r->wz*r->hz;

    /* sticks or slips, as in slider.h */
    const double angle = twist[0] + r->dt*rate;
    const double trial = -stiffness*angle - damping*rate, size = fabs(trial);
    const double limit = dem_select(r->fn > 0.0, l->friction*lever*r->fn, 0.0);
    const double moment =
        dem_select(size < limit, 1.0, limit/dem_select(size > 0.0, size, 1.0))*trial;
    const double effective = stiffness + damping*r->inverse_dt;
    const double slipped = (moment - trial)/dem_select(effective > 0.0, effective, 1.0);

    twist[0] = dem_select(limit > 0.0, dem_select(size < limit, angle, angle - slipped), 0.0);
    r->mx += moment*r->nx;
    r->my += moment*r->ny;
    r->mz += moment*r->nz;
}

/* as dem_slider_energy of slider_energy.h, for an angle */
DEM_MATH void dem_twisting_spring_energy_row(const struct dem_twisting_spring *l, const struct dem_contact_row *r,
    const double *before, const double *after, struct dem_energy_row *e)
{
    const double R = r->reduced_radius, from = before[0], to = after[0],
                 stiffness = r->touching*l->ratio*r->kn*R*r->overlap;
    const double was = l->ratio*e->previous_kn*R*e->previous_overlap;
    const double rate = r->wx*r->hx + r->wy*r->hy + r->wz*r->hz, slipped = from + r->dt*rate - to;
    const double damping = 2.0*l->damping*R*sqrt(0.4*r->reduced_mass*stiffness);
    const double dashpot = dem_select(r->fn > 0.0, damping*r->inverse_dt*(to - from), 0.0);
    const double damped =
        dashpot*(rate - 0.5*r->dt*(stiffness*to + dashpot)/e->inertia)*r->dt;

    e->stored = 0.5*stiffness*to*to;
    e->lost = damped + 0.5*(was*from + stiffness*to)*slipped - 0.5*(stiffness - was)*from*to;
}
