/*
 * geometry.h -- of one row: normals, overlap and relative motion from what was gathered of the partners.
 *
 * With n from j to i, the contact point lies at x_i - a_i n and x_j + a_j n. The arms are R - overlap/2 at a pair (their
 * sum is the distance, which conserves angular momentum) and R - overlap at a wall (the contact point lies on the wall).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_GEOMETRY_H
#define DEM_STEP_GEOMETRY_H

#include "base/math.h"
#include "effects/row.h"
#include "step/tray.h"
#include <math.h>

/* Of a pair: both normals, the raw overlap (below 0 apart), reduced radius and mass. One division serves them all, for divisions
   and roots take half of the time of a contact. */
static inline __attribute__((always_inline)) void dem_geometry_pair(const struct dem_gathered *g, int c, double dt, struct dem_row *r)
{
    const double half = 0.5*dt, rx = g->rx[c], ry = g->ry[c], rz = g->rz[c];
    const double hx = rx - half*g->vx[c], hy = ry - half*g->vy[c], hz = rz - half*g->vz[c];
    const double r2 = rx*rx + ry*ry + rz*rz, h2 = hx*hx + hy*hy + hz*hz;
    const double d = sqrt(r2), h = sqrt(h2), some_d = dem_pick(d > 0.0, d, 1.0), some_h = dem_pick(h > 0.0, h, 1.0);
    const double both = some_d*some_h, sums = g->radii[c]*g->inverse_mass[c], over = 1.0/(both*sums);
    const double over_both = over*sums, over_sums = over*both, over_d = over_both*some_h, over_h = over_both*some_d;

    /* coincident centres: any fixed direction will do, as long as all ranks take the same */
    r->nx = dem_pick(d > 0.0, rx*over_d, 1.0);
    r->ny = ry*over_d;
    r->nz = rz*over_d;
    r->hx = dem_pick(h > 0.0, hx*over_h, 1.0);
    r->hy = hy*over_h;
    r->hz = hz*over_h;
    r->overlap = g->radii[c] - d;
    r->reduced_radius = g->product[c]*(g->inverse_mass[c]*over_sums);
    r->reduced_mass = g->radii[c]*over_sums;
}

/* The rest, the raw overlap given, with results cleared. `share`: of what was gathered as spin; times this it is the mean of both
   partners. */
static inline __attribute__((always_inline)) void dem_geometry_motion(const struct dem_gathered *g, int c, double share, struct dem_row *r)
{
    const double raw = r->overlap, touch = dem_pick(raw > 0.0, 1.0, 0.0), overlap = dem_pick(raw > 0.0, raw, 0.0);
    const double hx = r->hx, hy = r->hy, hz = r->hz;
    const double along = g->vx[c]*hx + g->vy[c]*hy + g->vz[c]*hz;
    const double ax = g->ax[c] - overlap*g->bx[c], ay = g->ay[c] - overlap*g->by[c], az = g->az[c] - overlap*g->bz[c];

    r->overlap = overlap;
    r->touching = touch;
    r->vn = g->vx[c]*r->nx + g->vy[c]*r->ny + g->vz[c]*r->nz;
    r->sx = g->vx[c] - along*hx - (ay*hz - az*hy);
    r->sy = g->vy[c] - along*hy - (az*hx - ax*hz);
    r->sz = g->vz[c] - along*hz - (ax*hy - ay*hx);
    r->swing = share*(g->bx[c]*r->nx + g->by[c]*r->ny + g->bz[c]*r->nz);
    r->kn = r->kt = r->eta = r->grip = 0.0;
    r->fn = r->fx = r->fy = r->fz = 0.0;
}

#endif
