/*
 * liquid_bridge.h -- row function of liquid_bridge.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/row.h"

struct dem_liquid_bridge
{
    double tension, contact_angle, viscosity, roughness, max_volume, min_volume;
    int contact;
    double pull;       /* N/m  2 pi g cos(theta) */
    double extent;     /* 1    1 + theta/2 */
    double wall;       /* 1    1 at a wall, else 0 */
};

enum    /* `contact`: of the viscous force while surfaces touch */
{
    DEM_LIQUID_BRIDGE_ACTS,
    DEM_LIQUID_BRIDGE_RESTS
};

enum
{
    dem_liquid_bridge_columns = 1    /* V */
};

/* kg/s: of slip, over 6 pi mu R* */
DEM_MATH double dem_liquid_bridge_slip(double R, double h)
{
    return 8.0/15.0*dem_log(R/h) + 0.9588;
}

/* ---- the force ------------------------------------------------------------------------------- */

struct dem_capillary
{
    double force;     /* N  attraction */
    double energy;    /* J  potential, up to a constant */
};

/* At a gap, of a bridge with pull = 2 pi R g cos(theta) [N] and square = 2 V/(pi R) [m2]. */
DEM_MATH struct dem_capillary dem_capillary_at(double gap, double pull, double square)
{
    const double H = dem_select(gap > 0.0, gap, 0.0), overlap = H - gap,
                 root = sqrt(H*H + square);

    return (struct dem_capillary){
        .force = pull*(1.0 - H/dem_select(root > 0.0, root, 1.0)),
        .energy = pull*(H - root - overlap),
    };
}

/* Both dampers, on forces and loss; `holds`: 1 for a bridge. */
DEM_MATH void dem_liquid_bridge_viscous(const struct dem_liquid_bridge *l,
                                        struct dem_contact_row *r, double holds, double square)
{
    const double lowest = dem_select(l->contact == DEM_LIQUID_BRIDGE_RESTS, 0.0, -INFINITY);
    const double R = r->reduced_radius, m = r->reduced_mass, vn = r->vn;
    const double acts = dem_select((l->viscosity > 0.0) & (r->gap > lowest), holds, 0.0);
    const double thin = dem_select(r->gap > l->roughness, r->gap, l->roughness),
                 h = dem_select(acts > 0.0, thin, 1.0),
                 X = 1.0 - h/sqrt(h*h + square);
    const double scale = acts*6.0*3.14159265358979324*l->viscosity*R;
    const double squeeze = scale*R*X*X/h,
                 drag = scale*dem_liquid_bridge_slip(dem_select(acts > 0.0, R, 1.0), h);
    const double limit = m/(4.0*r->max_dt), slip_limit = 2.0/7.0*limit;
    const double cn = dem_select(squeeze < limit, squeeze, limit),
                 ct = dem_select(drag < slip_limit, drag, slip_limit);
    const double some_m = dem_select(m > 0.0, m, 1.0),
                 slip = r->sx*r->sx + r->sy*r->sy + r->sz*r->sz;

    r->fn -= cn*vn;
    r->fx -= ct*r->sx;
    r->fy -= ct*r->sy;
    r->fz -= ct*r->sz;
    /* exact for an isolated pair */
    r->lost += cn*vn*vn*r->dt*(1.0 - 0.5*cn*r->dt/some_m)
               + ct*slip*r->dt*(1.0 - 1.75*ct*r->dt/some_m);
}

/* `offered`: what a bridge that forms takes [m3]; volume: of the bridge, history. */
DEM_MATH void dem_liquid_bridge_force(const struct dem_liquid_bridge *l, struct dem_contact_row *r,
                                      double offered, double *volume)
{
    const double R = 2.0*r->reduced_radius, pull = l->pull*R, third = 1.0/3.0;
    const double before = dem_select(volume[0] > 0.0, volume[0], 0.0);
    const double dry = dem_select(before > 0.0, 0.0, r->touching);
    /* in the first evaluation, dt = 0, no liquid can be exchanged */
    const double taken = dem_select((dry > 0.0) & (offered > l->min_volume) & (r->is_primary > 0.0)
                                    & (r->dt > 0.0), offered, 0.0);
    const double V = before + taken, rupture = l->extent*dem_pow(V, third),
                 square = 2.0*V/(3.14159265358979324*dem_select(R > 0.0, R, 1.0));
    const double within = dem_select((r->gap < rupture) & (r->is_primary > 0.0), 1.0, 0.0),
                 still = dem_select(r->dt > 0.0, within, 1.0),
                 holds = dem_select(V > 0.0, still, 0.0);

    const struct dem_capillary now = dem_capillary_at(r->gap, pull, square),
                               was = dem_capillary_at(r->gap - r->dt*r->distance_rate, pull, square),
                               torn = dem_capillary_at(rupture, pull, square);
    const double held = dem_select(before > 0.0, 1.0, 0.0), half_way = 0.5*r->dt*r->distance_rate;

    r->fn -= holds*now.force;
    r->stored += holds*(now.energy - torn.energy);
    /* the force jumps at the end of the drift, and has done half of its work, or missed half */
    r->lost += dem_select(holds > held, half_way*now.force - (now.energy - torn.energy),
                          dem_select(holds < held, half_way*was.force + was.energy - torn.energy,
                                     0.0));
    dem_liquid_bridge_viscous(l, r, holds, square);
    volume[0] = holds*V;
}

/* ---- the liquid ------------------------------------------------------------------------------ */

/* 1: fraction of a sphere's surface that faces a partner */
DEM_MATH double dem_liquid_bridge_facing(double own, double other)
{
    const double sum = own + other, sine = other/dem_select(sum > 0.0, sum, 1.0);

    return 0.5*(1.0 - sqrt(1.0 - sine*sine));
}

DEM_MATH void dem_liquid_bridge_row(const struct dem_liquid_bridge *l, struct dem_contact_row *r,
                                    double *volume)
{
    struct dem_contact_scalar *const film = &r->scalars[0];
    const double before = dem_select(volume[0] > 0.0, volume[0], 0.0);
    const double of_i = dem_liquid_bridge_facing(film->radius_i, film->radius_j)*film->i,
                 of_j = (1.0 - l->wall)*dem_liquid_bridge_facing(film->radius_j, film->radius_i)*
                        film->j;
    const double limit = l->max_volume*r->min_radius*r->min_radius*r->min_radius, sum = of_i + of_j,
                 offered = dem_select(sum < limit, sum, limit),
                 part = offered/dem_select(sum > 0.0, sum, 1.0);

    dem_liquid_bridge_force(l, r, offered, volume);

    /* formed: each gives its part; broken: each gets half, a particle at a wall all */
    const double after = volume[0];
    const double formed = dem_select((before == 0.0) & (after > 0.0), r->inverse_dt, 0.0),
                 broken = dem_select((before > 0.0) & (after == 0.0), before*r->inverse_dt, 0.0);

    film->rate_i += 0.5*(1.0 + l->wall)*broken - formed*part*of_i;
    film->rate_j += 0.5*(1.0 - l->wall)*broken - formed*part*of_j;
}
