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
 * Friction under adhesion. The limit is mu (F + A), F the whole normal force with adhesion in it, A that by which the surfaces
 * hold each other besides:
 *
 *   jkr               A = 2 F_c, F_c = 3/2 pi w R*     Thornton, J. Phys. D 24 (1991) 1942; Marshall, J. Comput. Phys. 228 (2009) 1541
 *   hookeHysteresis   A = k_c d                        Luding, Granul. Matter 10 (2008) 235
 *   sjkr              A = w 2 pi R* d, its attraction: mu times the repulsion alone   Derjaguin, Z. Phys. 88 (1934) 661
 *
 * With `adhesion no` the limit is mu max(F_n, 0) of the normal law and its damping alone: Hertz's part with jkr, the sum with
 * hookeHysteresis.
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
    dem_real stiffness_was, mass;                         /* for the ledger only: k a step ago; what F moves, 0: much */
};

/* row c's spring of the step before in today's plane, loaded, and the rate there */
static inline __attribute__((always_inline)) struct dem_slider
dem_slider_load(const struct dem_block *b, int c, struct dem_slider s)
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

    s.sx = sx;
    s.sy = sy;
    s.sz = sz;
    s.xi_x = stays*bx + goes*ax + gx;
    s.xi_y = stays*by + goes*ay + gy;
    s.xi_z = stays*bz + goes*az + gz;
    return s;
}

/* the slider of row c one step on; with a limit of 0 no force and no spring is left */
static inline __attribute__((always_inline)) struct dem_slider
dem_slider_step(const struct dem_block *b, int c, struct dem_slider s)
{
    s = dem_slider_load(b, c, s);
    const dem_real sx = s.sx, sy = s.sy, sz = s.sz, ex = s.xi_x, ey = s.xi_y, ez = s.xi_z;

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

struct dem_rubbing
{
    dem_real friction, damped, grips;                     /* mu; 1: with the dashpot, with what adhesion holds by besides fn */
};

/* the slider of friction in row c, its spring still to be put in: dashpot of the normal law, limit by what pushes; two
   bodies slip as 2/7 m* does, for 1/m + R^2/I of both is 7/2 m* */
static inline __attribute__((always_inline)) struct dem_slider
dem_slider_friction(const struct dem_block *b, int c, dem_real stiffness, struct dem_rubbing rubs)
{
    const dem_real pressed = b->fn[c] + rubs.grips*b->grip[c];

    return (struct dem_slider){.stiffness = stiffness, .damping = rubs.damped*b->eta[c],
                               .limit = dem_pick(pressed > 0.0, rubs.friction*pressed, 0.0),
                               .sx = b->sx[c], .sy = b->sy[c], .sz = b->sz[c], .mass = b->reduced_mass[c]*(2.0/7.0)};
}

/*
 * What row c holds and has turned to heat in the step that dem_slider_step makes of s. With e the loaded spring, xi and xi'
 * the spring before (in today's plane) and after, k and k' its stiffness then and now,
 *
 *   stored   k' xi'^2/2
 *   slipped  (k xi + k' xi')/2 . (e - xi')       mean friction force times the distance slipped
 *   damped   c s (s + dt F/2 m) dt               while it holds; the rate in the middle of the kick, as far as F alone changes it
 *   rubbed   -F.(s + dt F/2 m) dt                where there is no spring
 *   changed  -(k' - k) xi.xi'/2                  a spring that stiffens as it is holds more than was put in: below 0
 *
 * Where partners are apart, or a bond takes the contact's place, the spring is forgotten, and what it held is lost. A spring
 * that is cut to spring and dashpot together as it begins to slip is longer than it was: slipped is below 0 then.
 */
static inline __attribute__((always_inline)) void
dem_slider_energy(const struct dem_block *b, int c, struct dem_slider s, struct dem_energy *restrict e)
{
    struct dem_slider still = s;

    still.sx = still.sy = still.sz = 0.0;
    const struct dem_slider from = dem_slider_load(b, c, still), loaded = dem_slider_load(b, c, s), to = dem_slider_step(b, c, s);
    const dem_real k = s.stiffness, was = s.stiffness_was, dt = b->dt, on = b->touching[c];
    const dem_real gx = loaded.xi_x - to.xi_x, gy = loaded.xi_y - to.xi_y, gz = loaded.xi_z - to.xi_z;
    const dem_real along = from.xi_x*gx + from.xi_y*gy + from.xi_z*gz, ahead = to.xi_x*gx + to.xi_y*gy + to.xi_z*gz;
    const dem_real both = from.xi_x*to.xi_x + from.xi_y*to.xi_y + from.xi_z*to.xi_z;
    const dem_real old = from.xi_x*from.xi_x + from.xi_y*from.xi_y + from.xi_z*from.xi_z;

    /* where it holds, nothing is cut */
    const dem_real holds = dem_pick((gx == 0.0) & (gy == 0.0) & (gz == 0.0), 1.0, 0.0);
    const dem_real square = to.sx*to.sx + to.sy*to.sy + to.sz*to.sz;
    const dem_real power = -(to.fx*to.sx + to.fy*to.sy + to.fz*to.sz);
    const dem_real gain = dem_pick(s.mass > 0.0, 0.5*dt/dem_pick(s.mass > 0.0, s.mass, 1.0), 0.0);
    const dem_real damped = holds*s.damping*(square - gain*power)*dt;
    const dem_real rubbed = (power - gain*(to.fx*to.fx + to.fy*to.fy + to.fz*to.fz))*dt;
    const dem_real lost = damped + 0.5*(was*along + k*ahead) - 0.5*(k - was)*both;

    e->stored[c] = on*0.5*k*(to.xi_x*to.xi_x + to.xi_y*to.xi_y + to.xi_z*to.xi_z);
    e->lost[c] = dem_pick(on > 0.0, dem_pick(k > 0.0, lost, rubbed), 0.5*was*old);
}

#endif
