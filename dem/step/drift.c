/*
 * drift.c -- x += dt v, four particles at a time, and the largest speed.
 *
 * Along periodic axes displacements are rounded to multiples of the domain's unit of length.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/drift.h"
#include "laws/effect.h"
#include <math.h>

DEM_KERNEL
static void drift_fours(struct dem_particle *restrict record, size_t n, double dt,
                        const double round[4], struct dem_drift_speeds *s)
{
    for (size_t i = 0; i + 4 <= n; i += 4)
    {
        dem_vec4 v[4] = {DEM_VEC4(record[i].v), DEM_VEC4(record[i + 1].v),
                         DEM_VEC4(record[i + 2].v), DEM_VEC4(record[i + 3].v)};

        dem_drift_four(record + i, v, dt, round);
        dem_transpose4(v);
        const dem_vec4 square = v[0]*v[0] + v[1]*v[1] + v[2]*v[2];

        dem_drift_count_speeds(s, &square);
    }
}

void dem_drift_particles(struct dem_particle *record, size_t n, double dt, const double round[4],
                         struct dem_drift_speeds *s)
{
    drift_fours(record, n, dt, round, s);
    for (size_t i = n/4*4; i < n; i++)
    {
        struct dem_particle *const r = &record[i];
        const double square = r->v[0]*r->v[0] + r->v[1]*r->v[1] + r->v[2]*r->v[2];

        for (size_t k = 0; k < 3; k++)
        {
            r->x[k] += (dt*r->v[k] + round[k]) - round[k];
        }
        s->max_square[0] = square > s->max_square[0] ? square : s->max_square[0];
        s->invalid[0] += square*0.0;
    }
}

double dem_drift_max_speed(const struct dem_drift_speeds *s)
{
    double max = 0.0, invalid = 0.0;

    for (size_t k = 0; k < 4; k++)
    {
        max = s->max_square[k] > max ? s->max_square[k] : max;
        invalid += s->invalid[k];
    }
    return invalid == 0.0 ? sqrt(max) : INFINITY;
}
