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

/* What is seen of a speed: its largest square, and 0 or not a number. */
struct seen
{
    double most[4], bad[4];
};

/* Four records at a time: their velocities turn into columns for the squares; radius and inverse mass stay as they are. */
DEM_KERNEL
static void drift_fours(struct dem_particle *restrict record, size_t n, double dt, const double round[4], struct seen *s)
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

double dem_motion_drift(struct dem_particles *p, double dt, const double round[4])
{
    struct seen s = {{0.0}, {0.0}};
    double most = 0.0, bad = 0.0;

    drift_fours(p->record, p->n, dt, round, &s);
    for (size_t k = 0; k < 4; k++)
    {
        most = s.most[k] > most ? s.most[k] : most;
        bad += s.bad[k];
    }
    for (size_t i = p->n/4*4; i < p->n; i++)
    {
        struct dem_particle *const r = &p->record[i];
        const double square = r->v[0]*r->v[0] + r->v[1]*r->v[1] + r->v[2]*r->v[2];

        for (size_t k = 0; k < 3; k++)
        {
            r->x[k] += (dt*r->v[k] + round[k]) - round[k];
        }
        most = square > most ? square : most;
        bad += square*0.0;
    }
    return bad == 0.0 ? sqrt(most) : INFINITY;
}
