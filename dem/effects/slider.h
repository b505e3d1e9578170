/*
 * slider.h -- a spring in the contact plane that turns with the pair and slips: of friction, and of rolling.
 *
 *   F = -k xi - c d(xi)/dt,   d(xi)/dt = s - p,   |F| <= limit,   p = 0 as long as it holds, else along -F
 *
 *   xi   elongation of the spring, in the contact plane            [m] or [rad]        remembered
 *   s    rate of both partners: slip of the contact point, or rolling                  [m/s] or [1/s]
 *   p    what of it the slider lets by                             [m/s] or [1/s]
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
 * Spring and dashpot lie side by side, and the slider in line with both. The whole of F, dashpot included, is held at the limit: the
 * impulse of a contact that slides all the way is the limit's. With e = xi + s dt and T = -k e - c s, what they would be and pull with if
 * they held, where |T| > limit the step (implicit in xi) has F along T and a spring that gives way by what slips,
 *
 *   F = limit T/|T|,    xi' = e + T/|T| p dt,    p dt = (|T| - limit)/(k + c/dt)
 *
 * so that none of the three ever gives: limit |p| dt, c |xi' - xi|^2/dt and the step's own k |xi' - xi|^2/2 are all above 0, and
 * -F.s dt = change of k xi^2/2 + these. In a steady slide xi comes to limit/k within some c/k, so F turns round no earlier than the spring
 * does. A spring that is cut to F at once, as is common, is longer than what slip has put in by the dashpot's share: energy
 * from nowhere, again each time that the limit falls and rises. Where the limit is 0 the spring is let go. At rest nothing is 0/0.
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
#include "effects/row.h"

struct dem_slider
{
    dem_real stiffness, damping, limit;                   /* k, c; largest |F| */
    dem_real often;                                       /* 1/dt: dem_slider_often */
    dem_real sx, sy, sz;                                  /* rate, in the plane of half a step ago */
    dem_real xi_x, xi_y, xi_z;                            /* spring: the last step's before, this step's after */
    dem_real fx, fy, fz;                                  /* F, after */
    dem_real stiffness_was, mass;                         /* for the ledger only: k a step ago; what F moves */
};

/* a row's spring of the step before in today's plane, loaded, and the rate there */
static inline __attribute__((always_inline)) struct dem_slider
dem_slider_load(const struct dem_row *r, struct dem_slider s)
{
    const dem_real nx = r->nx, ny = r->ny, nz = r->nz;
    const dem_real hx = r->hx, hy = r->hy, hz = r->hz;

    /* carry last step's spring into today's plane, half of the load on it; what is left along n goes, of spring and rate */
    const dem_real twice = 2*(hx*s.xi_x + hy*s.xi_y + hz*s.xi_z);
    const dem_real tilt = nx*s.sx + ny*s.sy + nz*s.sz, half = r->dt/2;
    const dem_real sx = s.sx - tilt*nx, sy = s.sy - tilt*ny, sz = s.sz - tilt*nz;
    const dem_real gx = half*sx, gy = half*sy, gz = half*sz;
    const dem_real cx = s.xi_x - twice*hx + gx, cy = s.xi_y - twice*hy + gy, cz = s.xi_z - twice*hz + gz;

    /* n x c lies in the plane; (n x c) x n is c in the plane */
    const dem_real ax = ny*cz - nz*cy, ay = nz*cx - nx*cz, az = nx*cy - ny*cx;
    const dem_real bx = ay*nz - az*ny, by = az*nx - ax*nz, bz = ax*ny - ay*nx;
    const dem_real q = half*r->swing, over = 1/(1 + q*q), stays = (1 - q*q)*over, goes = (q + q)*over;

    s.sx = sx;
    s.sy = sy;
    s.sz = sz;
    s.xi_x = stays*bx + goes*ax + gx;
    s.xi_y = stays*by + goes*ay + gy;
    s.xi_z = stays*bz + goes*az + gz;
    return s;
}

/* what spring and dashpot pull with as long as they hold */
static inline __attribute__((always_inline)) void dem_slider_pull(const struct dem_slider *s, dem_real t[3])
{
    t[0] = -s->stiffness*s->xi_x - s->damping*s->sx;
    t[1] = -s->stiffness*s->xi_y - s->damping*s->sy;
    t[2] = -s->stiffness*s->xi_z - s->damping*s->sz;
}

/* what a pull beyond the limit loses for each way that the slider lets by: k + c/dt */
static inline __attribute__((always_inline)) dem_real dem_slider_gives(const struct dem_slider *s)
{
    return s->stiffness + s->damping*s->often;
}

/* 1/dt; the first sweep has no step, so there no dashpot gives way */
static inline dem_real dem_slider_often(const struct dem_block *b)
{
    return b->dt > 0 ? 1/b->dt : (dem_real)1e15;
}

struct dem_slips                                          /* of a pull T, by what it is multiplied with */
{
    dem_real keep, back;                                  /* F = keep T, 1 where it holds; xi' = e + back T, 0 where it holds */
};

static inline __attribute__((always_inline)) struct dem_slips dem_slider_slips(dem_real square, dem_real limit, dem_real gives)
{
    const dem_real size = dem_root(square), whole = dem_pick(size > 0, size, 1), h = dem_pick(gives > 0, gives, 1);
    const dem_real over = 1/(whole*h);

    return (struct dem_slips){.keep = dem_pick(size < limit, 1, limit*h*over), .back = dem_pick(size < limit, 0, (size - limit)*over)};
}

/* holds or slips */
static inline __attribute__((always_inline)) struct dem_slider
dem_slider_let(struct dem_slider s, const dem_real t[3], struct dem_slips slips)
{
    s.xi_x = dem_pick(slips.keep > 0, s.xi_x + slips.back*t[0], 0);
    s.xi_y = dem_pick(slips.keep > 0, s.xi_y + slips.back*t[1], 0);
    s.xi_z = dem_pick(slips.keep > 0, s.xi_z + slips.back*t[2], 0);
    s.fx = slips.keep*t[0];
    s.fy = slips.keep*t[1];
    s.fz = slips.keep*t[2];
    return s;
}

/* the slider of a row one step on; with a limit of 0 no force and no spring is left */
static inline __attribute__((always_inline)) struct dem_slider
dem_slider_step(const struct dem_row *r, struct dem_slider s)
{
    dem_real t[3];

    s = dem_slider_load(r, s);
    dem_slider_pull(&s, t);
    return dem_slider_let(s, t, dem_slider_slips(t[0]*t[0] + t[1]*t[1] + t[2]*t[2], s.limit, dem_slider_gives(&s)));
}

/*
 * The same for a block in three loops, for a root and a division that wait for each other are waited for one after the other in
 * a long loop and all together in a short one: with what the hot chain does besides, 17 cycles a row become 15. The first loop is the effect's own and ends with
 * dem_slider_begin, the others are dem_slider_finish. The bits are those of dem_slider_step.
 */
enum
{
    DEM_SLIDER_X,
    DEM_SLIDER_Y,
    DEM_SLIDER_Z,
    DEM_SLIDER_LIMIT,                                     /* then keep */
    DEM_SLIDER_GIVES                                      /* then back */
};

/* s: its spring loaded; that goes to xi by the caller */
static inline __attribute__((always_inline)) void dem_slider_begin(struct dem_block *b, int c, const struct dem_slider *s)
{
    dem_real t[3];

    dem_slider_pull(s, t);
    b->between[DEM_SLIDER_X][c] = t[0];
    b->between[DEM_SLIDER_Y][c] = t[1];
    b->between[DEM_SLIDER_Z][c] = t[2];
    b->between[DEM_SLIDER_LIMIT][c] = s->limit;
    b->between[DEM_SLIDER_GIVES][c] = dem_slider_gives(s);
}

static inline __attribute__((always_inline)) void dem_slider_cuts(struct dem_block *b)
{
    dem_real (*const at)[DEM_BLOCK] = b->between;

    for (int c = 0; c < b->n; c++)
    {
        const dem_real x = at[DEM_SLIDER_X][c], y = at[DEM_SLIDER_Y][c], z = at[DEM_SLIDER_Z][c];
        const struct dem_slips slips = dem_slider_slips(x*x + y*y + z*z, at[DEM_SLIDER_LIMIT][c], at[DEM_SLIDER_GIVES][c]);

        at[DEM_SLIDER_LIMIT][c] = slips.keep;
        at[DEM_SLIDER_GIVES][c] = slips.back;
    }
}

/* row c after the cuts, its loaded spring given */
static inline __attribute__((always_inline)) struct dem_slider
dem_slider_end(const struct dem_block *b, int c, dem_real x, dem_real y, dem_real z)
{
    const struct dem_slider s = {.xi_x = x, .xi_y = y, .xi_z = z};
    const struct dem_slips slips = {.keep = b->between[DEM_SLIDER_LIMIT][c], .back = b->between[DEM_SLIDER_GIVES][c]};
    const dem_real t[3] = {b->between[DEM_SLIDER_X][c], b->between[DEM_SLIDER_Y][c], b->between[DEM_SLIDER_Z][c]};

    return dem_slider_let(s, t, slips);
}

/* fx, fy, fz: the tray's columns to add F to; x, y, z: the springs, loaded before and as they are after */
static inline __attribute__((always_inline)) void
dem_slider_finish(struct dem_block *restrict b, dem_real *const f[3], dem_real *restrict x, dem_real *restrict y, dem_real *restrict z)
{
    dem_real *const fx = f[0], *const fy = f[1], *const fz = f[2];

    dem_slider_cuts(b);
    for (int c = 0; c < b->n; c++)
    {
        const struct dem_slider s = dem_slider_end(b, c, x[c], y[c], z[c]);

        x[c] = s.xi_x;
        y[c] = s.xi_y;
        z[c] = s.xi_z;
        fx[c] += s.fx;
        fy[c] += s.fy;
        fz[c] += s.fz;
    }
}

struct dem_rubbing
{
    dem_real friction, damped, grips;                     /* mu; 1: with the dashpot, with what adhesion holds by besides fn */
    dem_real often;                                       /* 1/dt: dem_slider_often */
};

/* the slider of friction in a row, its spring still to be put in: dashpot of the normal law, limit by what pushes */
static inline __attribute__((always_inline)) struct dem_slider
dem_slider_friction(const struct dem_row *r, dem_real stiffness, struct dem_rubbing rubs)
{
    const dem_real pressed = r->fn + rubs.grips*r->grip;

    return (struct dem_slider){.stiffness = stiffness, .damping = rubs.damped*r->eta,
                               .limit = dem_pick(pressed > 0, rubs.friction*pressed, 0), .often = rubs.often,
                               .sx = r->sx, .sy = r->sy, .sz = r->sz};
}

/*
 * What row c holds and has turned to heat in the step that dem_slider_step makes of s. With e the loaded spring, xi and xi'
 * the spring before (in today's plane) and after, k and k' its stiffness then and now, and m what F moves,
 *
 *   stored   k' xi'^2/2
 *   slipped  (k xi + k' xi')/2 . (e - xi')       mean force of the spring times the distance slipped
 *   damped   -(F + k' xi').(s + dt F/2 m) dt     force of the dashpot; the rate in the middle of the kick, as far as F alone changes it
 *   rubbed   -F.(s + dt F/2 m) dt                where there is no spring
 *   changed  -(k' - k) xi.xi'/2                  a spring that stiffens as it is holds more than was put in: below 0
 *
 * Where partners are apart, or a bond takes the contact's place, the spring is forgotten: k', xi' and F are 0, and of what was
 * held a step ago, k xi^2/2, that is lost which the last drift has not had: it ended with no force, so half of k xi.s dt.
 */
static inline __attribute__((always_inline)) void
dem_slider_energy(const struct dem_block *b, int c, struct dem_slider s, struct dem_energy *restrict e)
{
    const struct dem_row r = dem_row_at(b, c);
    struct dem_slider still = s;

    still.sx = still.sy = still.sz = 0;
    const struct dem_slider from = dem_slider_load(&r, still), loaded = dem_slider_load(&r, s), to = dem_slider_step(&r, s);
    const dem_real on = b->touching[c], k = on*s.stiffness, was = s.stiffness_was, dt = b->dt;
    const dem_real xi_x = on*to.xi_x, xi_y = on*to.xi_y, xi_z = on*to.xi_z, fx = on*to.fx, fy = on*to.fy, fz = on*to.fz;
    const dem_real gx = loaded.xi_x - xi_x, gy = loaded.xi_y - xi_y, gz = loaded.xi_z - xi_z;
    const dem_real along = from.xi_x*gx + from.xi_y*gy + from.xi_z*gz, ahead = xi_x*gx + xi_y*gy + xi_z*gz;
    const dem_real both = from.xi_x*xi_x + from.xi_y*xi_y + from.xi_z*xi_z;

    const dem_real gain = dt/(2*s.mass), ux = to.sx + gain*fx, uy = to.sy + gain*fy, uz = to.sz + gain*fz;
    const dem_real damped = -((fx + k*xi_x)*ux + (fy + k*xi_y)*uy + (fz + k*xi_z)*uz)*dt;
    const dem_real rubbed = -(fx*ux + fy*uy + fz*uz)*dt;
    const dem_real lost = damped + (was*along + k*ahead)/2 - (k - was)/2*both;

    e->stored[c] = k/2*(xi_x*xi_x + xi_y*xi_y + xi_z*xi_z);
    e->lost[c] = dem_pick((on > 0) & !(k > 0), rubbed, lost);
}

#endif
