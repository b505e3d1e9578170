/*
 * slider.h -- a spring in the contact plane that turns with the pair and slips: of friction, and of rolling.
 *
 *   F = -k xi - c s,   |F| <= limit,   d xi = s dt as long as it holds, else xi = -F/k
 *
 *   xi   elongation of the spring, in the contact plane            [m] or [rad]        remembered
 *   s    its rate: slip of the contact point, or rolling           [m/s] or [1/s]
 *   k, c spring and dashpot                                        [N/m], [kg/s] or [N m], [N m s]
 *
 * Carrying the spring into the new contact plane: positions move with the half-step velocity, r_new = r_old + dt v,
 * so h = unit(r_new - dt v/2) points along r_old + r_new and halves the angle between n_old and n when |r| is kept.
 * The mirror at the plane normal to h, xi - 2 (h.xi) h, maps n_old to -n, hence the plane normal to n_old to that
 * normal to n; in these planes it is the smallest rotation that takes n_old to n, and it keeps every length, of slip
 * as of rolling. Then dt s is added and what points along n (second order in dt: s lies normal to h, and |r| changes a
 * little) is taken off. Where h = n (flat walls), mirror and cut together are a plain projection.
 *
 * The pair also spins about n, by the mean of both spins: the spring is turned about n by 2 atan(q), q = dt swing/2,
 *
 *   xi' = R (xi + dt s/2) + dt s/2,    R a = ((1 - q^2) a + 2 q n x a)/(1 + q^2)
 *
 * which keeps its length, is the same backwards, and loads it in the middle of the turn. Without it a pair that spins
 * as a whole would pull ever elsewhere; with half of the symmetry it would feed energy to it.
 *
 * The whole of F, dashpot included, is held at the limit, and the spring is cut to F: then the impulse of a contact that
 * slides all the way is the limit's, and F turns round no earlier than the spring does. At rest nothing is 0/0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_SLIDER_H
#define DEM_EFFECTS_SLIDER_H

#include "base/math.h"
#include "effects/block.h"

struct dem_slider
{
    dem_real stiffness, damping, limit;                   /* k, c; largest |F| */
    dem_real sx, sy, sz;                                  /* rate, in the plane of half a step ago */
    dem_real xi_x, xi_y, xi_z;                            /* spring: the last step's before, this step's after */
    dem_real fx, fy, fz;                                  /* F, after */
};

/* the slider of row c one step on; with a limit of 0 no force and no spring is left */
static inline __attribute__((always_inline)) struct dem_slider
dem_slider_step(const struct dem_block *b, int c, struct dem_slider s)
{
    const dem_real nx = b->nx[c], ny = b->ny[c], nz = b->nz[c];
    const dem_real hx = b->hx[c], hy = b->hy[c], hz = b->hz[c], dt = b->dt;

    /* carry last step's spring into today's plane, half of the load on it; what is left along n goes, of spring and rate */
    const dem_real twice = 2.0*(hx*s.xi_x + hy*s.xi_y + hz*s.xi_z);
    const dem_real tilt = nx*s.sx + ny*s.sy + nz*s.sz, half = 0.5*dt;
    const dem_real sx = s.sx - tilt*nx, sy = s.sy - tilt*ny, sz = s.sz - tilt*nz;
    const dem_real gx = half*sx, gy = half*sy, gz = half*sz;
    const dem_real rx = s.xi_x - twice*hx + gx, ry = s.xi_y - twice*hy + gy, rz = s.xi_z - twice*hz + gz;

    /* n x r lies in the plane; (n x r) x n is r in the plane */
    const dem_real ax = ny*rz - nz*ry, ay = nz*rx - nx*rz, az = nx*ry - ny*rx;
    const dem_real bx = ay*nz - az*ny, by = az*nx - ax*nz, bz = ax*ny - ay*nx;
    const dem_real q = half*b->swing[c], over = 1.0/(1.0 + q*q), stays = (1.0 - q*q)*over, goes = (q + q)*over;
    const dem_real ex = stays*bx + goes*ax + gx, ey = stays*by + goes*ay + gy, ez = stays*bz + goes*az + gz;

    /* holds or slips */
    const dem_real tx = -s.stiffness*ex - s.damping*sx;
    const dem_real ty = -s.stiffness*ey - s.damping*sy;
    const dem_real tz = -s.stiffness*ez - s.damping*sz;
    const dem_real size = sqrt(tx*tx + ty*ty + tz*tz);
    const dem_real whole = dem_pick(size > 0.0, size, 1.0), k = dem_pick(s.stiffness > 0.0, s.stiffness, 1.0);
    const dem_real cut = s.limit/(whole*k), keep = dem_pick(size < s.limit, 1.0, cut*k);

    s.xi_x = dem_pick(size < s.limit, ex, 0.0 - cut*tx);
    s.xi_y = dem_pick(size < s.limit, ey, 0.0 - cut*ty);
    s.xi_z = dem_pick(size < s.limit, ez, 0.0 - cut*tz);
    s.fx = keep*tx;
    s.fy = keep*ty;
    s.fz = keep*tz;
    return s;
}

#endif
