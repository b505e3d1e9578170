/*
 * geometry.h -- of one row: normals, overlap and relative motion from what was gathered of the partners.
 *
 * With n from j to i, the contact point lies at x_i - a_i n and x_j + a_j n. The arms are R - overlap/2 at a pair (their
 * sum is the distance, which conserves angular momentum) and R - overlap at a wall (the contact point lies on the wall).
 *
 * Distance and overlap are worked out in double precision, whatever the laws have: an overlap is a small difference.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_GEOMETRY_H
#define DEM_STEP_GEOMETRY_H

#include "base/math.h"
#include "effects/row.h"
#include "step/gathered.h"
#include <math.h>

/* Of a pair: both normals, the raw overlap (below 0 apart), reduced radius and mass, the lesser radius. One division serves them all,
   for divisions and roots take half of the time of a contact. */
static inline __attribute__((always_inline)) void dem_geometry_pair(const struct dem_gathered *g, int c, double dt, struct dem_row *r)
{
    const double x = g->rx[c], y = g->ry[c], z = g->rz[c], distance = sqrt(x*x + y*y + z*z);
    const dem_real half = (dem_real)(0.5*dt), rx = (dem_real)x, ry = (dem_real)y, rz = (dem_real)z, d = (dem_real)distance;
    const dem_real hx = rx - half*(dem_real)g->vx[c], hy = ry - half*(dem_real)g->vy[c], hz = rz - half*(dem_real)g->vz[c];
    const dem_real h = dem_root(hx*hx + hy*hy + hz*hz), some_d = dem_pick(d > 0, d, 1), some_h = dem_pick(h > 0, h, 1);
    const dem_real radii = (dem_real)g->radii[c], over_mass = (dem_real)g->inverse_mass[c];
    const dem_real radius = (dem_real)g->radius[c], other = (dem_real)g->other[c];
    const dem_real both = some_d*some_h, sums = radii*over_mass, over = 1/(both*sums);
    const dem_real over_both = over*sums, over_sums = over*both, over_d = over_both*some_h, over_h = over_both*some_d;

    /* coincident centres: any fixed direction will do, as long as all ranks take the same */
    r->nx = dem_pick(d > 0, rx*over_d, 1);
    r->ny = ry*over_d;
    r->nz = rz*over_d;
    r->hx = dem_pick(h > 0, hx*over_h, 1);
    r->hy = hy*over_h;
    r->hz = hz*over_h;
    r->overlap = (dem_real)(g->radii[c] - distance);
    r->reduced_radius = radius*other*(over_mass*over_sums);
    r->reduced_mass = radii*over_sums;
    r->least_radius = dem_pick(radius < other, radius, other);
}

/* The same of all rows of a block. */
static inline __attribute__((always_inline)) void dem_geometry_pairs(struct dem_block *restrict b, const struct dem_gathered *restrict g, double dt)
{
    for (int c = 0; c < b->n; c++)
    {
        struct dem_row r;

        dem_geometry_pair(g, c, dt, &r);
        b->nx[c] = r.nx;
        b->ny[c] = r.ny;
        b->nz[c] = r.nz;
        b->hx[c] = r.hx;
        b->hy[c] = r.hy;
        b->hz[c] = r.hz;
        b->overlap[c] = r.overlap;
        b->reduced_radius[c] = r.reduced_radius;
        b->reduced_mass[c] = r.reduced_mass;
        b->least_radius[c] = r.least_radius;
    }
}

/* The rest, the raw overlap given, with results cleared. `share`: of half of what was gathered as spin; times this it is the mean of
   both partners. */
static inline __attribute__((always_inline)) void
dem_geometry_motion(const struct dem_gathered *g, int c, dem_real share, struct dem_row *r)
{
    const dem_real raw = r->overlap, touch = dem_pick(raw > 0, (dem_real)1, 0), overlap = dem_pick(raw > 0, raw, 0);
    const dem_real vx = (dem_real)g->vx[c], vy = (dem_real)g->vy[c], vz = (dem_real)g->vz[c];
    const dem_real bx = (dem_real)g->bx[c]/2, by = (dem_real)g->by[c]/2, bz = (dem_real)g->bz[c]/2;
    const dem_real hx = r->hx, hy = r->hy, hz = r->hz;
    const dem_real along = vx*hx + vy*hy + vz*hz;
    const dem_real ax = (dem_real)g->ax[c] - overlap*bx, ay = (dem_real)g->ay[c] - overlap*by, az = (dem_real)g->az[c] - overlap*bz;

    r->overlap = overlap;
    r->touching = touch;
    r->vn = vx*r->nx + vy*r->ny + vz*r->nz;
    r->sx = vx - along*hx - (ay*hz - az*hy);
    r->sy = vy - along*hy - (az*hx - ax*hz);
    r->sz = vz - along*hz - (ax*hy - ay*hx);
    r->swing = share*(bx*r->nx + by*r->ny + bz*r->nz);
    r->kn = r->kt = r->eta = r->grip = 0;
    r->fn = r->fx = r->fy = r->fz = 0;
}

#endif
