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
#ifndef DEM_LAWS_SLIDER_H
#define DEM_LAWS_SLIDER_H

#include "core/math.h"
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
    /* for dem_slider_energy only: k of the last step; effective mass */
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
    const double tilt = nx*s.sx + ny*s.sy + nz*s.sz, half = r->dt/2;
    const double sx = s.sx - tilt*nx, sy = s.sy - tilt*ny, sz = s.sz - tilt*nz;
    const double gx = half*sx, gy = half*sy, gz = half*sz;
    const double cx = s.xi_x - twice*hx + gx, cy = s.xi_y - twice*hy + gy,
                   cz = s.xi_z - twice*hz + gz;

    /* n x c lies in the plane; (n x c) x n is c in the plane */
    const double ax = ny*cz - nz*cy, ay = nz*cx - nx*cz, az = nx*cy - ny*cx;
    const double bx = ay*nz - az*ny, by = az*nx - ax*nz, bz = ax*ny - ay*nx;
    const double q = half*r->normal_spin, over = 1/(1 + q*q), cosine = (1 - q*q)*over,
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
DEM_MATH void dem_slider_trial_force(const struct dem_slider *s,
                            double t[3])
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

/* One step of the slider of a row; with a limit of 0 force and spring become 0. xi: the spring, in and
   out. */
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

/* The same for the loop of a law; f, xi: force, to which F is added, and spring. */
DEM_MATH void dem_slider_row(const struct dem_contact_row *r, struct dem_slider s, double *f[3],
                             double *xi)
{
    s = dem_slider_step(r, s);
    xi[0] = s.xi_x;
    xi[1] = s.xi_y;
    xi[2] = s.xi_z;
    *f[0] += s.fx;
    *f[1] += s.fy;
    *f[2] += s.fz;
}

/*
 * The same in three loops over a batch, for fused kernels: in one long loop the latencies of square
 * roots and divisions add up, in short ones they overlap. The first loop is that of the kernel and
 * calls dem_slider_begin, the last one dem_slider_end. The results have the bits of dem_slider_step.
 */
struct dem_slider_columns
{
    _Alignas(64) double x[DEM_BATCH_ROWS], y[DEM_BATCH_ROWS], z[DEM_BATCH_ROWS];    /* T */
    /* limit and effective stiffness; after dem_slider_limit_forces force_factor and spring_factor */
    _Alignas(64) double limit[DEM_BATCH_ROWS], stiffness[DEM_BATCH_ROWS];
};

/* xi: the spring; out, its trial elongation */
DEM_MATH void dem_slider_begin(const struct dem_contact_row *r, struct dem_slider s,
                               struct dem_slider_columns *to, int c, double *xi)
{
    double t[3];

    s = dem_slider_load(r, s);
    dem_slider_trial_force(&s, t);
    xi[0] = s.xi_x;
    xi[1] = s.xi_y;
    xi[2] = s.xi_z;
    to->x[c] = t[0];
    to->y[c] = t[1];
    to->z[c] = t[2];
    to->limit[c] = s.limit;
    to->stiffness[c] = dem_slider_effective_stiffness(&s);
}

DEM_MATH void dem_slider_limit_forces(struct dem_slider_columns *t, int n)
{
    for (int c = 0; c < n; c++)
    {
        const struct dem_slider_limited l =
            dem_slider_limit_force(t->x[c]*t->x[c] + t->y[c]*t->y[c] + t->z[c]*t->z[c],
                                   t->limit[c], t->stiffness[c]);

        t->limit[c] = l.force_factor;
        t->stiffness[c] = l.spring_factor;
    }
}

/* f: force, to which F is added; xi: trial elongation, out: the spring */
DEM_MATH void dem_slider_end(const struct dem_slider_columns *t, int c, double *f[3], double *xi)
{
    const struct dem_slider e = {.xi_x = xi[0], .xi_y = xi[1], .xi_z = xi[2]};
    const struct dem_slider s =
        dem_slider_apply_limit(e, (const double[3]){t->x[c], t->y[c], t->z[c]},
                               (struct dem_slider_limited){.force_factor = t->limit[c],
                                                           .spring_factor = t->stiffness[c]});

    xi[0] = s.xi_x;
    xi[1] = s.xi_y;
    xi[2] = s.xi_z;
    *f[0] += s.fx;
    *f[1] += s.fy;
    *f[2] += s.fz;
}

/*
 * Energy stored and dissipated by row c in the step that dem_slider_step makes of s. With e the
 * trial elongation, xi and xi' the elongation before (in the new plane) and after, k and k' the
 * stiffness before and after, and m the effective mass,
 *
 *   stored   k' xi'^2/2
 *   slipped  (k xi + k' xi')/2 . (e - xi')      mean spring force times the slip distance
 *   damped   -(F + k' xi').(s + dt F/2 m) dt    work of the dashpot, with the velocity in the
 *                                               middle of the kick as far as F alone changes it
 *   rubbed   -F.(s + dt F/2 m) dt               friction where there is no spring
 *   changed  -(k' - k) xi.xi'/2                 a spring that becomes stiffer at constant
 *                                               elongation gains energy that nothing has put in:
 *                                               < 0
 *
 * Where the partners are apart, or a bond replaces the contact, the spring is reset: k', xi' and F
 * are 0. Of the energy k xi^2/2 of the last step the part is dissipated that has not become work of
 * the last drift, which ended with no force: half of k xi.s dt.
 */
DEM_MATH void
dem_slider_energy(const struct dem_contact_batch *b, int c, struct dem_slider s,
                  struct dem_energy *restrict e)
{
    const struct dem_contact_row r = dem_contact_row_load(b, c, s.inverse_dt);
    struct dem_slider at_rest = s;

    at_rest.sx = at_rest.sy = at_rest.sz = 0;
    const struct dem_slider from = dem_slider_load(&r, at_rest), loaded = dem_slider_load(&r, s),
                            to = dem_slider_step(&r, s);
    const double on = b->touching[c], k = on*s.stiffness, was = s.previous_stiffness, dt = b->dt;
    const double xi_x = on*to.xi_x, xi_y = on*to.xi_y, xi_z = on*to.xi_z, fx = on*to.fx,
                   fy = on*to.fy, fz = on*to.fz;
    const double gx = loaded.xi_x - xi_x, gy = loaded.xi_y - xi_y, gz = loaded.xi_z - xi_z;
    const double along = from.xi_x*gx + from.xi_y*gy + from.xi_z*gz,
                   ahead = xi_x*gx + xi_y*gy + xi_z*gz;
    const double both = from.xi_x*xi_x + from.xi_y*xi_y + from.xi_z*xi_z;

    const double gain = dt/(2*s.mass), ux = to.sx + gain*fx, uy = to.sy + gain*fy,
                   uz = to.sz + gain*fz;
    const double damped = -((fx + k*xi_x)*ux + (fy + k*xi_y)*uy + (fz + k*xi_z)*uz)*dt;
    const double rubbed = -(fx*ux + fy*uy + fz*uz)*dt;
    const double lost = damped + (was*along + k*ahead)/2 - (k - was)/2*both;

    e->stored[c] = k/2*(xi_x*xi_x + xi_y*xi_y + xi_z*xi_z);
    e->lost[c] = dem_select((on > 0) & !(k > 0), rubbed, lost);
}

#endif
