/*
 * drift.h -- the drift of a leapfrog step in kick-drift form, x += dt v. The kicks are in
 * sweep_bodies.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/math.h"
#include "particles/particles.h"
#include "core/vec4.h"

struct dem_drift_speeds    /* speeds so far, in four lanes; start with zeros */
{
    double max_square[4], invalid[4];  /* m2/s2: largest square of a speed;
                                          0, or not a number if one was */
};

/* Four records with the velocities v (and inverse masses). The fourth number of x, the radius, is not
   changed. */
__attribute__((always_inline)) static inline void
dem_drift_four(struct dem_particle *record, const dem_vec4 v[4], double dt, const double round[4])
{
    const dem_vec4 rounding = DEM_VEC4(round), step = {dt, dt, dt, 0.0};

    for (int k = 0; k < 4; k++)
    {
        DEM_VEC4_AT(record[k].x) += ((step*v[k] + rounding) - rounding);
    }
}

__attribute__((always_inline)) static inline void
dem_drift_count_speeds(struct dem_drift_speeds *s, const dem_vec4 *squares)
{
    const dem_vec4 square = *squares;

    for (int k = 0; k < 4; k++)
    {
        s->max_square[k] = dem_select(square[k] > s->max_square[k], square[k], s->max_square[k]);
        s->invalid[k] += square[k]*0.0;
    }
}

/* Drift n particles over dt [s]. Adding and subtracting dem_domain.round rounds each displacement
   to a multiple of the domain's unit of length. Their speeds are added to the last argument. */
void dem_drift_particles(struct dem_particle *, size_t n, double dt, const double round[4],
                         struct dem_drift_speeds *);

/* The largest speed [m/s]; infinite if a speed was not a number. */
double dem_drift_max_speed(const struct dem_drift_speeds *);
