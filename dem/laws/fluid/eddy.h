/*
 * eddy.h -- turbulent fluctuation of the fluid velocity at a particle: eddies one after the other.
 *
 *   u' = sqrt(2 k/3) g,   rate of leaving an eddy = 1/T + |w|/L
 *   T = C_t k/epsilon,    L = C_l k^(3/2)/epsilon
 *
 *   g        three normal random numbers of an eddy, mean 0, variance 1                 [1]
 *   k        turbulent kinetic energy of the fluid, epsilon its dissipation  [m2/s2], [m2/s3]
 *   T, L     integral time scale of the fluid, length of an eddy                   [s], [m]
 *   w        velocity of the fluid, with u', relative to the particle                 [m/s]
 *
 * Time in an eddy is distributed as exp(-t rate), so with w = 0 the autocorrelation of u' is
 * exp(-t/T). A time of one mean, by a random number when the eddy begins, is used up at this rate.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/math.h"
#include "core/random.h"

struct dem_eddies
{
    double lifetime, length;  /* 1  C_t, C_l; length 0: eddies are not crossed */
    uint64_t seed;
};

/* u' of g = 1 [m/s] */
static inline double dem_eddy_speed(double k)
{
    return sqrt(2.0/3.0*(k > 0.0 ? k : 0.0));
}

/* 1/s; 0 where there is no turbulence */
static inline double dem_eddy_rate(const struct dem_eddies *e, double k, double epsilon,
                                   double slip)
{
    const int turbulent = k > 0.0 && epsilon > 0.0;
    const double crossed = turbulent && e->length > 0.0 ? slip*epsilon/(e->length*k*sqrt(k)) : 0.0;

    return turbulent ? epsilon/(e->lifetime*k) + crossed : 0.0;
}

/* A new eddy: g, and the time in it in units of 1/rate, by the particle's id and the step. Pairs of
   normal numbers by the polar method (Marsaglia and Bray 1964). */
static inline void dem_eddy_begin(const struct dem_eddies *e, uint64_t id, uint64_t step,
                                  double eddy[4])
{
    uint64_t use = 0;

    eddy[3] = -dem_log(1.0 - dem_random_unit(e->seed, id, step, use++));
    for (int pair = 0; pair < 2; pair++)
    {
        double x, y, s;

        do
        {
            x = 2.0*dem_random_unit(e->seed, id, step, use++) - 1.0;
            y = 2.0*dem_random_unit(e->seed, id, step, use++) - 1.0;
            s = x*x + y*y;
        } while (s >= 1.0 || s == 0.0);
        s = sqrt(-2.0*dem_log(s)/s);
        eddy[2*pair] = s*x;
        if (pair == 0)
        {
            eddy[1] = s*y;
        }
    }
}
