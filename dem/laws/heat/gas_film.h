/*
 * gas_film.h -- row function of gas_film.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/row.h"

struct dem_gas_film
{
    double conductivity, min_gap, thickness;
    double real_overlap;    /* of the real material, over the scene's [1] */
    double wall;            /* 1: the class is one with walls */
};

#define DEM_GAS_FILM_TWO_PI 6.28318530717958648

struct dem_gas_film_pair    /* l, D^2, and what they are multiplied by: 1/4, 1 at a wall */
{
    double l, D2, factor;
};

/* int r/s dr to the gap s, up to a constant */
DEM_MATH double dem_gas_film_over_gap(const struct dem_gas_film_pair *p, double s)
{
    const double l = p->l, log_s = dem_log(s);
    const double m = dem_select(l > s, l - s, l);    /* l = s only where D = 0 */

    return p->factor*(l*log_s - s - p->D2*(((log_s - dem_log(m))/l + 1.0/m)/(l*l) + 0.5/(l*m*m)));
}

/* int r dr between two gaps; the difference is taken before it is rounded */
DEM_MATH double dem_gas_film_area(const struct dem_gas_film_pair *p, double s1, double s2)
{
    const double m1 = p->l - s1, m2 = p->l - s2, mm = m1*m2;

    return 0.5*p->factor*(s2 - s1)*(m1 + m2)*
           (1.0 - p->D2/dem_select(mm > 0.0, mm*mm, 1.0));
}

/* Conductance over 2 pi k [m], radii R <= L, distance l, thickness of the film t L. */
DEM_MATH double dem_gas_film_integral(const struct dem_gas_film *g, double R, double L, double l,
                                      double touches)
{
    const double film = L*(1.0 + g->thickness);
    const double along = dem_select(g->wall > 0.0, l, 0.5*(film*film - R*R + l*l)/l);
    const double square = film*film - along*along, most = R*R;
    /* r_b^2, 0 where the film does not meet the surface */
    const double outer = dem_select(along > l, most, dem_select(square > 0.0, square, 0.0));
    const double r2 = dem_select(outer < most, outer, most);
    const double u = sqrt(R*R - r2), v = dem_select(g->wall > 0.0, 0.0, sqrt(L*L - r2));
    const struct dem_gas_film_pair p = {
        .l = l,
        .D2 = dem_select(g->wall > 0.0, 0.0, (L*L - R*R)*(L*L - R*R)),
        .factor = dem_select(g->wall > 0.0, 1.0, 0.25)};
    const double s0 = g->min_gap, apart = l - R - dem_select(g->wall > 0.0, 0.0, L);
    const double end = l - u - v;
    const double begin = dem_select(touches > 0.0, 0.0, dem_select(apart > 0.0, apart, 0.0));
    const double last = dem_select(end > begin, end, begin);
    /* [begin, middle]: gaps below s_0; [first, last]: above */
    const double middle = dem_select(last < s0, last, dem_select(begin > s0, begin, s0));
    const double first = dem_select(begin > s0, begin, s0);
    const double open = dem_select(last > first, last, first);

    return dem_gas_film_area(&p, begin, middle)/s0 + dem_gas_film_over_gap(&p, open) -
           dem_gas_film_over_gap(&p, first);
}

DEM_MATH void dem_gas_film_row(const struct dem_gas_film *l, struct dem_contact_row *r,
                               double *history)
{
    struct dem_contact_scalar *const t = &r->scalars[0];
    const double factor = DEM_GAS_FILM_TWO_PI*l->conductivity;
    const double touches = dem_select(r->gap < 0.0, 1.0, 0.0);
    const double gap = r->gap*dem_select(touches > 0.0, l->real_overlap, 1.0);
    const double R = dem_select(r->min_radius > 0.0, r->min_radius, 1.0);
    const double other = r->distance - r->gap - R, L = dem_select(other > R, other, R);
    const double sum = R + dem_select(l->wall > 0.0, 0.0, L);
    const double heat = r->is_primary*factor*
                        dem_gas_film_integral(l, R, L, sum + gap, touches)*(t->j - t->i);

    (void)history;
    t->rate_i += heat;
    t->rate_j -= heat;
}
