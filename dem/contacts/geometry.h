/*
 * geometry.h -- normals, overlap and relative motion of one contact row, from the gathered data of
 * its partners. Devices compile it, too.
 *
 * With n from j to i, the contact point lies at x_i - a_i n and x_j + a_j n. The lever arms a are R
 * - overlap/2 at a pair (their sum is the distance, which conserves angular momentum) and R -
 * overlap at a wall (the contact point lies on the wall).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "contacts/gathered.h"
#include "laws/row.h"

/* Geometry of a pair: the normals now and half a step ago, the raw overlap (negative where there is a
   gap), reduced radius and mass, the smaller radius. All quotients come from one division, because
   divisions and square roots take half of the time of a contact. */
DEM_MATH void dem_geometry_pair(const struct dem_gathered *g, int c, double dt,
                                struct dem_contact_row *r)
{
    const double half_dt = 0.5*dt;
    const double rx = g->rx[c], ry = g->ry[c], rz = g->rz[c], d = sqrt(rx*rx + ry*ry + rz*rz);
    const double hx = rx - half_dt*g->vx[c], hy = ry - half_dt*g->vy[c],
                   hz = rz - half_dt*g->vz[c];
    const double h = sqrt(hx*hx + hy*hy + hz*hz), nonzero_d = dem_select(d > 0, d, 1),
                   nonzero_h = dem_select(h > 0, h, 1);
    const double radii = g->radii[c], over_mass = g->inverse_mass[c];
    const double radius = g->radius[c], other = g->other[c];
    const double both = nonzero_d*nonzero_h, sums = radii*over_mass, over = 1/(both*sums);
    const double over_both = over*sums, over_sums = over*both, over_d = over_both*nonzero_h,
                   over_h = over_both*nonzero_d;

    /* coincident centres: any fixed direction is valid, as long as all ranks use the same */
    r->nx = dem_select(d > 0, rx*over_d, 1);
    r->ny = ry*over_d;
    r->nz = rz*over_d;
    r->hx = dem_select(h > 0, hx*over_h, 1);
    r->hy = hy*over_h;
    r->hz = hz*over_h;
    r->overlap = radii - d;
    r->reduced_radius = radius*other*(over_mass*over_sums);
    r->reduced_mass = radii*over_sums;
    r->min_radius = dem_select(radius < other, radius, other);
}

/* Overlap, touching mask and relative motion from the raw overlap in r.
   `spin_factor` times half of the gathered sum of spins is the mean spin of both partners: 1 at a
   pair, 1/2 at a wall. */
DEM_MATH void dem_geometry_motion(const struct dem_gathered *g, int c, double spin_factor,
                                  struct dem_contact_row *r)
{
    const double raw = r->overlap, touch = dem_select(raw > 0, 1, 0),
                   overlap = dem_select(raw > 0, raw, 0);
    const double vx = g->vx[c], vy = g->vy[c], vz = g->vz[c];
    const double bx = g->bx[c]/2, by = g->by[c]/2, bz = g->bz[c]/2;
    const double hx = r->hx, hy = r->hy, hz = r->hz;
    const double along = vx*hx + vy*hy + vz*hz;
    const double ax = g->ax[c] - overlap*bx, ay = g->ay[c] - overlap*by,
                   az = g->az[c] - overlap*bz;

    r->overlap = overlap;
    r->touching = touch;
    r->vn = vx*r->nx + vy*r->ny + vz*r->nz;
    r->sx = vx - along*hx - (ay*hz - az*hy);
    r->sy = vy - along*hy - (az*hx - ax*hz);
    r->sz = vz - along*hz - (ax*hy - ay*hx);
    r->normal_spin = spin_factor*(bx*r->nx + by*r->ny + bz*r->nz);
}
