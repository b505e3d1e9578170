/*
 * ladder.h -- what a ladder of runs tells of one quantity: its value where the knob's error is gone, how sure that is, and
 * how far each rung is from it.
 *
 * A rung is some runs that differ in nothing but up to 4 % of the step, so that contacts begin at other fractions of a
 * step and, where motion is chaotic, go other ways. Its mean is m, its standard deviation s, the number of its runs n; its size h is
 * what the error goes to zero with (the step; the contact time), rungs go from coarse to fine.
 *
 * The reference q, and how unsure it is, u:
 *
 *   closed        given; u = 0
 *   extrapolated  of the three finest, of constant ratio r = h2/h1: p = ln((m3 - m2)/(m2 - m1))/ln r, q = m1 - (m2 - m1)/(r^p - 1);
 *                 u is the distance to what the next three say (without a fourth: to m1), and what scatter makes of q (95 %).
 *                 Where the means do not close in on a value with 1/2 < p < 4, q = m1 and u the largest of the last two differences.
 *   statistics    where scatter does not fall with the step like any error of the step would, and is not small beside what the rungs
 *                 differ by: then it is the scene's own (chaos), q = m1 and u the 95 % interval of that mean;
 *                 all runs have the scene's one start, so it holds for that start, not for others like it
 *
 * The error of a rung: sqrt(mean of (value - q)^2), what one run is off by; with statistics |m - q|, for the scatter is not
 * the knob's, with the 95 % interval of that difference (Welch's, with the fewer degrees of freedom of the two).
 *
 * The observed order is the slope of ln(error) over ln(h), rungs whose error is not above 2 u left out, and its standard error.
 *
 * Source: Richardson, Phil. Trans. R. Soc. A 210 (1911) 307; the order from three grids: Roache, J. Fluids Eng. 116 (1994) 405.
 * Not here: which quantities, which knobs (main_cost*.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_PLAN_LADDER_H
#define DEM_PLAN_LADDER_H

enum
{
    DEM_LADDER_RUNGS = 18,
    DEM_LADDER_RUNS = 32                                  /* of a rung, at most */
};

enum dem_ladder_kind
{
    DEM_LADDER_CLOSED,
    DEM_LADDER_EXTRAPOLATED,
    DEM_LADDER_STATISTICS
};

struct dem_ladder_rung
{
    double size;                                          /* h, any unit */
    int runs;
    double value[DEM_LADDER_RUNS];

    double mean, scatter;                                 /* derived: m, s; in the quantity's unit like all below */
    double error, unsure;                                 /* and by how much that may be off (95 %) */
};

struct dem_ladder
{
    int rungs;                                            /* from coarse to fine, h falls; rungs that failed are not among them */
    struct dem_ladder_rung rung[DEM_LADDER_RUNGS];
    int closed;                                           /* 1: the reference is given */

    double reference, unsure;                             /* q, u */
    enum dem_ladder_kind kind;
    double order, order_unsure;                           /* not a number where fewer than three rungs tell */
};

/* One rung at least, two runs in each for a scatter. */
void dem_ladder_judge(struct dem_ladder *);

/* Mean and standard deviation. */
void dem_ladder_moments(const double *value, int n, double *mean, double *scatter);

const char *dem_ladder_kind_name(enum dem_ladder_kind);

#endif
