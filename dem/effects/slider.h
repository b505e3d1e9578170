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
 * The whole of F, dashpot included, is held at the limit, and the spring is cut to F: then the impulse of a contact that
 * slides all the way is the limit's, and F turns round no earlier than the spring does. At rest nothing is 0/0.
 *
 * Not here: turning of the spring with a common spin of the pair about n.
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

    /* carry last step's spring into today's plane and load it; what is left along n goes, of spring and rate */
    const dem_real twice = 2.0*(hx*s.xi_x + hy*s.xi_y + hz*s.xi_z);
    const dem_real tilt = nx*s.sx + ny*s.sy + nz*s.sz;
    const dem_real sx = s.sx - tilt*nx;
    const dem_real sy = s.sy - tilt*ny;
    const dem_real sz = s.sz - tilt*nz;
    const dem_real rx = s.xi_x - twice*hx;
    const dem_real ry = s.xi_y - twice*hy;
    const dem_real rz = s.xi_z - twice*hz;
    const dem_real lean = nx*rx + ny*ry + nz*rz;
    const dem_real ex = rx - lean*nx + dt*sx;
    const dem_real ey = ry - lean*ny + dt*sy;
    const dem_real ez = rz - lean*nz + dt*sz;

    /* holds or slips */
    const dem_real tx = -s.stiffness*ex - s.damping*sx;
    const dem_real ty = -s.stiffness*ey - s.damping*sy;
    const dem_real tz = -s.stiffness*ez - s.damping*sz;
    const dem_real size = sqrt(tx*tx + ty*ty + tz*tz);
    const dem_real keep = dem_pick(size < s.limit, 1.0, s.limit/dem_pick(size > 0.0, size, 1.0));
    const dem_real cut = keep/dem_pick(s.stiffness > 0.0, s.stiffness, 1.0);

    s.xi_x = dem_pick(size < s.limit, ex, -cut*tx);
    s.xi_y = dem_pick(size < s.limit, ey, -cut*ty);
    s.xi_z = dem_pick(size < s.limit, ez, -cut*tz);
    s.fx = keep*tx;
    s.fy = keep*ty;
    s.fz = keep*tz;
    return s;
}

#endif
