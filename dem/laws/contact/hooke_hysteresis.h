/*
 * hooke_hysteresis.h -- normal force of one contact, the row function of hooke_hysteresis.c, which
 * has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_HOOKE_HYSTERESIS_H
#define DEM_LAWS_HOOKE_HYSTERESIS_H

#include "laws/contact/impact_speed.h"
#include "laws/row.h"

struct dem_hooke_hysteresis
{
    double stiffness, impact_speed;
    double unloading, adhesion, depth;
    struct dem_impact_spring spring;  /* derived */
    double limit;                     /* 1    d_lim over R*, derived */
    double stiffer;                   /* 1    (k_m - k)/k, derived; 0: a linear spring */
};

enum
{
    dem_hooke_hysteresis_columns = 1    /* d_max */
};

/* before the rows */
DEM_MATH void dem_hooke_hysteresis_before(const struct dem_hooke_hysteresis *l,
                                          struct dem_contact_batch *b)
{
    dem_impact_stiffness(&l->spring, b);
}

/* k_n: of dem_hooke_hysteresis_before */
DEM_MATH void dem_hooke_hysteresis_row(const struct dem_hooke_hysteresis *l,
                                       struct dem_contact_row *r, double *largest)
{
    const double slope = 4.0*(1.0 + l->adhesion)/dem_select(l->stiffer > 0.0, l->stiffer, 1.0);
    const double k = r->kn, d = r->overlap, d_lim = l->limit*r->reduced_radius;
    const double max_overlap = dem_select(largest[0] > d, largest[0], d);
    const int beyond_limit = max_overlap >= d_lim;
    const double reference = dem_select(beyond_limit, d_lim, max_overlap);
    const double k_2 =
        k*(1.0 + l->stiffer*dem_select(beyond_limit, 1.0,
                                       max_overlap/dem_select(d_lim > 0.0, d_lim, 1.0)));

    /* the unloading line, between first loading and the adhesive branch */
    const double line = k_2*(d - reference) + k*reference, load = k*d, stick = -l->adhesion*k*d;
    const double upper = dem_select(beyond_limit | (line < load), line, load);
    const int adheres = upper < stick;

    largest[0] = dem_select(adheres, 0.5*(d + sqrt(d*d + slope*d_lim*d)), max_overlap);
    r->fn += dem_select(adheres, stick, upper);
    r->adhesive_force = -stick;
}

#endif
