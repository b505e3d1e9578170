/*
 * motion.c -- one loop.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/motion.h"
#include <math.h>

double dem_motion_drift(struct dem_particles *p, double dt)
{
    double most = 0.0, bad = 0.0;

    for (size_t i = 0; i < p->n; i++)
    {
        struct dem_particle *const r = &p->record[i];
        const double square = r->v[0]*r->v[0] + r->v[1]*r->v[1] + r->v[2]*r->v[2];

        r->x[0] += dt*r->v[0];
        r->x[1] += dt*r->v[1];
        r->x[2] += dt*r->v[2];
        most = square > most ? square : most;
        bad += square*0.0;                                /* 0, or not a number */
    }
    return bad == 0.0 ? sqrt(most) : INFINITY;
}
