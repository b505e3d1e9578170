/*
 * lubrication.h -- row function of lubrication.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/row.h"

struct dem_lubrication
{
    double viscosity;
    double roughness;
    double cut_off;
    int contact;
};

enum    /* `contact`: of the film while surfaces touch */
{
    DEM_LUBRICATION_ACTS,
    DEM_LUBRICATION_RESTS
};

/* 6 pi mu R*^2 times 1/thickness [kg/s] */
DEM_MATH double dem_lubrication_damping(double mu, double R, double over_thickness)
{
    const double six_pi = 18.8495559215387594;

    return six_pi*mu*R*R*over_thickness;
}

DEM_MATH void dem_lubrication_row(const struct dem_lubrication *l, struct dem_contact_row *r,
                                  double *history)
{
    /* m  gap below which it does not act */
    const double lowest = dem_select(l->contact == DEM_LUBRICATION_RESTS, 0.0, -INFINITY);
    const double min_gap = l->roughness, max_gap = l->cut_off;
    const double R = r->reduced_radius, m = r->reduced_mass, vn = r->vn;
    const double mu = dem_select(r->gap > lowest,
                                 dem_select(l->viscosity > 0.0, l->viscosity, r->viscosity), 0.0);
    const double h = dem_select(r->gap > min_gap, r->gap, min_gap);
    const double thin = dem_select(h < max_gap, 1.0/h - 1.0/max_gap, 0.0);
    const double film = r->is_primary*dem_lubrication_damping(mu, R, thin);
    const double limit = m/(4.0*r->max_dt);
    const double damper = dem_select(film < limit, film, limit);

    (void)history;
    r->fn -= damper*vn;
    /* exact for an isolated pair */
    r->lost += damper*vn*r->dt*(vn - 0.5*damper*vn*r->dt/dem_select(m > 0.0, m, 1.0));
}
