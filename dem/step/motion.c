/*
 * motion.c -- x += dt v, by fours, in whole multiples along periodic axes; and how fast the fastest is.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/motion.h"
#include "base/math.h"
#include "effects/effect.h"
#include "step/quad.h"
#include <math.h>

/* Four records at a time: their velocities turn into columns for the squares; radius and inverse mass stay as they are. */
DEM_KERNEL
static void drift_fours(struct dem_particle *restrict record, size_t n, double dt, const double round[4],
                        struct dem_motion_seen *s)
{
    const dem_quad whole = DEM_QUAD(round);
    const dem_quad step = {dt, dt, dt, 0.0};

    for (size_t i = 0; i + 4 <= n; i += 4)
    {
        dem_quad v[4], square;

        for (size_t k = 0; k < 4; k++)
        {
            v[k] = DEM_QUAD(record[i + k].v);
            DEM_QUAD_AT(record[i + k].x) += ((step*v[k] + whole) - whole);
        }
        dem_quad_turn(v);
        square = v[0]*v[0] + v[1]*v[1] + v[2]*v[2];
        for (size_t k = 0; k < 4; k++)
        {
            s->most[k] = dem_pick(square[k] > s->most[k], square[k], s->most[k]);
            s->bad[k] += square[k]*0.0;
        }
    }
}

void dem_motion_drift(struct dem_particle *record, size_t n, double dt, const double round[4], struct dem_motion_seen *s)
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
        s->most[0] = square > s->most[0] ? square : s->most[0];
        s->bad[0] += square*0.0;
    }
}

double dem_motion_fastest(const struct dem_motion_seen *s)
{
    double most = 0.0, bad = 0.0;

    for (size_t k = 0; k < 4; k++)
    {
        most = s->most[k] > most ? s->most[k] : most;
        bad += s->bad[k];
    }
    return bad == 0.0 ? sqrt(most) : INFINITY;
}
