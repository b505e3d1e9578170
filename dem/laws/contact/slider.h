/*
 * slider.h -- tangential spring, dashpot and slider, for friction and rolling resistance.
 *
 *   F = -k xi - c d(xi)/dt,   d(xi)/dt = s - p,   |F| <= limit
 *   p = 0 while sticking, along -F while slipping
 *
 *   xi   elongation of the spring, in the contact plane (history)  [m] or [rad]
 *   s    relative velocity: slip at the contact point, or rolling  [m/s] or [1/s]
 *   p    slip velocity of the slider                               [m/s] or [1/s]
 *   k, c spring stiffness, damping coefficient                     [N/m], [kg/s] or [N m], [N m s]
 *
 * Rotation into the new contact plane. Positions move with the half-step velocity,
 * r_new = r_old + dt v, so h = unit(r_new - dt v/2) points along r_old + r_new and halves the angle
 * between n_old and n if |r| is constant. The reflection at the plane normal to h, xi - 2 (h.xi) h,
 * maps n_old to -n, hence the plane normal to n_old to the plane normal to n; within these planes
 * it is the smallest rotation from n_old to n, and it keeps every length, for slip as for rolling.
 * Then dt s is added, and the component along n is removed (second order in dt: s is normal to h,
 * and |r| changes a little). Where h = n (flat walls), reflection and removal together are a plain
 * projection.
 *
 * Rotation about n. The pair also spins about n, by the mean of both spins: the spring is turned
 * about n by 2 atan(q), q = dt swing/2,
 *
 *   xi' = R (xi + dt s/2) + dt s/2,    R a = ((1 - q^2) a + 2 q n x a)/(1 + q^2)
 *
 * which keeps its length, is time-reversible, and adds the increment in the middle of the rotation.
 * Without it the force of a pair that spins as a whole would point in a wrong direction; with an
 * unsymmetric form the pair would gain energy.
 *
 * Slip. Spring and dashpot are in parallel, and the slider in series with both. The whole of F,
 * dashpot included, is limited: a contact that slides throughout has the impulse of the
 * limit. With the trial elongation e = xi + s dt and the trial force T = -k e - c s (sticking), a
 * step with |T| > limit, implicit in xi, has F along T, and the spring is shortened by the slip:
 *
 *   F = limit T/|T|,    xi' = e + T/|T| p dt,    p dt = (|T| - limit)/(k + c/dt)
 *
 * so that none of the three produces energy: limit |p| dt, c |xi' - xi|^2/dt and the numerical
 * dissipation k |xi' - xi|^2/2 of the step are all > 0, and -F.s dt = change of k xi^2/2 + these.
 * In steady sliding xi reaches limit/k within a few c/k, so F reverses no earlier than the spring
 * does. A spring that is cut to F at once, as is common, is longer than the slip has put in by the
 * part of the dashpot: energy is created each time the limit decreases and increases. Where the
 * limit is 0 the spring is reset. At rest nothing is 0/0.
 *
 * Friction with adhesion. The limit is mu (F + A), F the total normal force, adhesion included, and
 * A the adhesive force of the law:
 *
 *   jkr               A = 2 F_c, F_c = 3/2 pi w R*     Thornton, J. Phys. D 24 (1991) 1942;
 *                                                      Marshall, J. Comput. Phys. 228 (2009) 1541
 *   hookeHysteresis   A = k_c d                        Luding, Granul. Matter 10 (2008) 235
 *   sjkr              A = w 2 pi R* d, its attraction: mu times the repulsion alone
 *                                                      Derjaguin, Z. Phys. 88 (1934) 661
 *
 * With `adhesion no` the limit is mu max(F_n, 0) of the normal law and its damping alone: the Hertz
 * part with jkr, the sum with hookeHysteresis.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/row.h"

struct dem_slider
{
    double stiffness, damping, limit;                   /* k, c; limit of |F| */
    double inverse_dt;                                    /* 1/dt */
    /* s, in the contact plane of half a step ago */
    double sx, sy, sz;
    /* xi: in, of the last step; out, of this step */
    double xi_x, xi_y, xi_z;
    double fx, fy, fz;                                  /* F, out */
    /* for slider_energy.h only: k of the last step; effective mass */
    double previous_stiffness, mass;
};

/* Rotates the spring of the last step into the new contact plane and adds the increment: trial
   elongation e, and s in that plane. */
DEM_MATH struct dem_slider
dem_slider_load(const struct dem_contact_row *r, struct dem_slider s)
{
    const double nx = r->nx, ny = r->ny, nz = r->nz;
    const double hx = r->hx, hy = r->hy, hz = r->hz;

    /* reflect the spring into the new plane, add half of the increment; drop the components
       along n */
    const double twice = 2*(hx*s.xi_x + hy*s.xi_y + hz*s.xi_z);
    const double tilt = nx*s.sx + ny*s.sy + nz*s.sz, dt2 = r->dt/2;
    const double sx = s.sx - tilt*nx, sy = s.sy - tilt*ny, sz = s.sz - tilt*nz;
    const double gx = dt2*sx, gy = dt2*sy, gz = dt2*sz;
    const double cx = s.xi_x - twice*hx + gx, cy = s.xi_y - twice*hy + gy,
                   cz = s.xi_z - twice*hz + gz;

    /* n x c lies in the plane; (n x c) x n is c in the plane */
    const double ax = ny*cz - nz*cy, ay = nz*cx - nx*cz, az = nx*cy - ny*cx;
    const double bx = ay*nz - az*ny, by = az*nx - ax*nz, bz = ax*ny - ay*nx;
    const double q = dt2*r->normal_spin, over = 1/(1 + q*q), cosine = (1 - q*q)*over,
                   sine = (q + q)*over;

    s.sx = sx;
    s.sy = sy;
    s.sz = sz;
    s.xi_x = cosine*bx + sine*ax + gx;
    s.xi_y = cosine*by + sine*ay + gy;
    s.xi_z = cosine*bz + sine*az + gz;
    return s;
}

/* Trial force T of spring and dashpot (sticking). */
DEM_MATH void dem_slider_trial_force(const struct dem_slider *s, double t[3])
{
    t[0] = -s->stiffness*s->xi_x - s->damping*s->sx;
    t[1] = -s->stiffness*s->xi_y - s->damping*s->sy;
    t[2] = -s->stiffness*s->xi_z - s->damping*s->sz;
}

/* Effective stiffness k + c/dt: decrease of |T| per slip distance. */
DEM_MATH double dem_slider_effective_stiffness(
    const struct dem_slider *s)
{
    return s->stiffness + s->damping*s->inverse_dt;
}

struct dem_slider_limited    /* result of limiting a trial force T */
{
    /* F = force_factor T, xi' = e + spring_factor T; 1 and 0 while sticking */
    double force_factor, spring_factor;
};

DEM_MATH struct dem_slider_limited dem_slider_limit_force(
    double square, double limit, double gives)
{
    const double size = sqrt(square), size_or_1 = dem_select(size > 0, size, 1),
                   h = dem_select(gives > 0, gives, 1);
    const double over = 1/(size_or_1*h);

    return (struct dem_slider_limited){
        .force_factor = dem_select(size < limit, 1, limit*h*over),
        .spring_factor = dem_select(size < limit, 0, (size - limit)*over)};
}

/* Applies the limit: F and the new elongation. */
DEM_MATH struct dem_slider
dem_slider_apply_limit(struct dem_slider s, const double t[3], struct dem_slider_limited slips)
{
    s.xi_x = dem_select(slips.force_factor > 0, s.xi_x + slips.spring_factor*t[0], 0);
    s.xi_y = dem_select(slips.force_factor > 0, s.xi_y + slips.spring_factor*t[1], 0);
    s.xi_z = dem_select(slips.force_factor > 0, s.xi_z + slips.spring_factor*t[2], 0);
    s.fx = slips.force_factor*t[0];
    s.fy = slips.force_factor*t[1];
    s.fz = slips.force_factor*t[2];
    return s;
}

/* One step of the slider of a row; with a limit of 0 force and spring become 0. */
DEM_MATH struct dem_slider dem_slider_step(const struct dem_contact_row *r, struct dem_slider s)
{
    double t[3];

    s = dem_slider_load(r, s);
    dem_slider_trial_force(&s, t);
    return dem_slider_apply_limit(s, t,
                                  dem_slider_limit_force(t[0]*t[0] + t[1]*t[1] + t[2]*t[2],
                                                         s.limit,
                                                         dem_slider_effective_stiffness(&s)));
}

/* The spring of this step into the history of a law. */
DEM_MATH void dem_slider_keep(const struct dem_slider *s, double *xi)
{
    xi[0] = s->xi_x;
    xi[1] = s->xi_y;
    xi[2] = s->xi_z;
}
