/*
 * hooke_hysteresis.h -- normal force of one contact, the row function of hooke_hysteresis.c, which
 * has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/contact/impact_spring.h"
#include "laws/energy_row.h"

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

/* The force, k_n being known. */
DEM_MATH void dem_hooke_hysteresis_force_row(const struct dem_hooke_hysteresis *l,
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

DEM_MATH void dem_hooke_hysteresis_row(const struct dem_hooke_hysteresis *l,
                                       struct dem_contact_row *r, double *largest)
{
    dem_impact_stiffness_row(&l->spring, r);
    dem_hooke_hysteresis_force_row(l, r, largest);
}

/* ---- energy ---------------------------------------------------------------------------------- */

/* divided by k of first loading: forces become lengths, energies squared lengths */
struct dem_unloading_line
{
    /* 1, m: k_2/k of the unloading line, and its overlap at zero force */
    double slope, start;
    double spent;                                       /* m2: plastic work of loading to d_max */
};

/* First loading to d_max takes d_max^2/2, of which unloading returns d_max^2/2 k/k_2; beyond d_lim
   nothing yields. */
DEM_MATH struct dem_unloading_line
dem_unloading_line(const struct dem_hooke_hysteresis *h, double max_overlap,
                                            double d_lim)
{
    const double reference = dem_select(max_overlap < d_lim, max_overlap, d_lim);
    const double slope =
        1.0 + h->stiffer*dem_select(max_overlap < d_lim,
                                      max_overlap/dem_select(d_lim > 0.0, d_lim, 1.0), 1.0);

    return (struct dem_unloading_line){.slope = slope,
                                   .start = reference - reference/slope,
                                   .spent = 0.5*reference*reference*(1.0 - 1.0/slope)};
}

/* Recoverable energy on the unloading line: k_2 (d - d_0)^2/2, compressed or stretched. */
DEM_MATH double dem_unloading_elastic(struct dem_unloading_line y, double d)
{
    return 0.5*y.slope*(d - y.start)*(d - y.start);
}

/* Dissipated: the plastic work by which d_max grows; on the adhesive branch, from where the old
   unloading line meets -k_c d to the present overlap, the work of the motion, a difference of
   k_c d^2/2, plus the decrease of the energy recoverable on the unloading line. */
DEM_MATH void dem_hooke_hysteresis_energy_row(const struct dem_hooke_hysteresis *l, const struct dem_contact_row *r,
    const double *before, const double *after, struct dem_energy_row *e)
{
    const double k = r->kn, d = r->overlap, d_lim = l->limit*r->reduced_radius;
    const double old = dem_select(before[0] > d, before[0], d), now = after[0];
    const struct dem_unloading_line from = dem_unloading_line(l, old, d_lim),
                                    to = dem_unloading_line(l, dem_select(now > d, now, d), d_lim),
                                    first = dem_unloading_line(l, before[0], d_lim);

    /* d_max decreased: adhesive branch; the old unloading line met it at `meets`, at once if it
       was there before */
    const double meets = from.slope*from.start/(from.slope + l->adhesion);
    const double sticking = 0.5*l->adhesion*(meets*meets - d*d) +
                            dem_unloading_elastic(from, meets) - dem_unloading_elastic(to, d);

    e->stored = k*dem_unloading_elastic(to, d);
    e->lost = k*dem_select(now < old, sticking, from.spent - first.spent);
}
