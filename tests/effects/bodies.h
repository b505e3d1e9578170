/*
 * bodies.h -- a body batch filled by hand: particles in a fluid, one a row.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/effects.h"
#include "unit/tap.h"

#include <string.h>

static inline double sphere_volume(double diameter)
{
    return 3.14159265358979324/6.0*diameter*diameter*diameter;
}

/* row c: a sphere at rest in a fluid that moves along x so that the superficial Reynolds number is
   re */
static inline void body_fill(struct dem_body_batch *b, int c, double diameter, double rho,
                             double mu, double e, double re)
{
    b->radius[c] = 0.5*diameter;
    b->volume[c] = sphere_volume(diameter);
    b->sphericity[c] = b->crosswise[c] = b->lengthwise[c] = 1.0;
    b->mass[c] = 2500.0*b->volume[c];
    b->vx[c] = b->vy[c] = b->vz[c] = 0.0;
    b->void_fraction[c] = e;
    b->density[c] = rho;
    b->viscosity[c] = mu;
    b->ux[c] = e > 0.0 ? re*mu/(e*rho*diameter) : 0.0;
    b->uy[c] = b->uz[c] = 0.0;
    b->drag[c] = b->drag_ux[c] = b->drag_uy[c] = b->drag_uz[c] = b->fx[c] = b->fy[c] = b->fz[c] =
        0.0;
}

/* G of a drag law: b over 3 pi mu d, for a sphere of 1 mm in water-like fluid */
static inline double body_drag(const struct dem_effect *law, const void *settings, double e,
                               double re)
{
    static struct dem_body_batch b;

    memset(&b, 0, sizeof b);
    b.n = 1;
    body_fill(&b, 0, 1e-3, 1000.0, 1e-3, e, re);
    dem_effect_apply_to_bodies(law, settings, &b);
    return b.drag[0]/(3.0*3.14159265358979324*1e-3*1e-3);
}
