/*
 * refinement_series.h -- convergence study of one quantity: reference, errors, order.
 *
 * A refinement series consists of levels, from coarse to fine. A level is some runs that differ
 * only by up to 4 % in the time step, so that contacts begin at other fractions of a step and,
 * where the motion is chaotic, take other paths. It has the mean m, the standard deviation s, the
 * number of runs n, and the size h with which the error goes to zero (the time step; the contact
 * time).
 *
 * The reference q and its uncertainty u:
 *
 *   closed        q is given (closed form); u = 0
 *   extrapolated  from the three finest levels of constant ratio r = h2/h1:
 *                 p = ln((m3 - m2)/(m2 - m1))/ln r,  q = m1 - (m2 - m1)/(r^p - 1);
 *                 u is the distance to the value from the next three levels (without a fourth: to
 *                 m1), plus the effect of scatter on q (95 %). If the means do not converge with
 *                 1/2 < p < 4, q = m1 and u is the larger of the last two differences.
 *   statistics    if scatter does not decrease with the time step as any error of it would, and is
 *                 not small compared with the differences between levels: then it is a property of
 *                 the scene (chaos), q = m1 and u is the 95 % confidence interval of that mean. All
 *                 runs have the same initial state, so the result holds for that state only.
 *
 * The error of a level is sqrt(mean of (value - q)^2), the error of a single run; with statistics
 * |m - q|, because the scatter is not an error of h, with the 95 % confidence interval of that
 * difference (Welch, with the smaller of the two degrees of freedom).
 *
 * The observed order is the slope of ln(error) over ln(h), with its standard error; levels whose
 * error is not above 2 u are left out.
 *
 * Source: Richardson, Phil. Trans. R. Soc. A 210 (1911) 307; the order from three grids: Roache, J.
 * Fluids Eng. 116 (1994) 405.
 * Not here: which quantities and parameters are studied (app/cost*.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_ADVISOR_REFINEMENT_SERIES_H
#define DEM_ADVISOR_REFINEMENT_SERIES_H

enum
{
    DEM_REFINEMENT_LEVELS = 18,
    DEM_REFINEMENT_RUNS = 32                                  /* of a level, at most */
};

enum dem_refinement_kind
{
    DEM_REFINEMENT_CLOSED,
    DEM_REFINEMENT_EXTRAPOLATED,
    DEM_REFINEMENT_STATISTICS
};

struct dem_refinement_level
{
    double size;                                          /* h, any unit */
    int runs;
    double value[DEM_REFINEMENT_RUNS];

    /* derived: m, s; in the unit of the quantity, as all below */
    double mean, scatter;
    double error, uncertainty;                                 /* and its uncertainty (95 %) */
};

struct dem_refinement_series
{
    /* from coarse to fine, h decreases; without failed ones */
    int levels;
    struct dem_refinement_level level[DEM_REFINEMENT_LEVELS];
    int closed;                                           /* 1: the reference is given */

    double reference, uncertainty;                             /* q, u */
    enum dem_refinement_kind kind;
    /* observed order and its standard error; not a number with fewer than three usable levels */
    double order, order_uncertainty;
};

/* Computes all derived values. Needs one level at least, and two runs in each for a scatter. */
void dem_refinement_evaluate(struct dem_refinement_series *);

/* Mean and standard deviation of n values. */
void dem_refinement_moments(const double *value, int n, double *mean, double *scatter);

const char *dem_refinement_kind_name(enum dem_refinement_kind);

#endif
