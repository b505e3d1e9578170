/*
 * mindlin.c -- a contact resists slip like a spring that friction lets go.
 *
 *   F_t = -k_t xi - eta_t s,    k_t = 8 G* sqrt(R* d),    |F_t| <= mu max(F_n, 0)
 *
 *   xi     elongation of the spring, in the contact plane          [m]    remembered
 *   s      slip velocity of i's contact point over j's             [m/s]
 *   k_t    tangential stiffness                                    [N/m]
 *   G*     reduced shear modulus, 1/G* = sum 2 (2 - nu)(1 + nu)/E  [Pa]
 *   R*, d  reduced radius, overlap                                 [m]
 *   eta_t  the normal law's damping coefficient, or 0              [kg/s]
 *   mu     coefficient of friction                                 [1]
 *   F_n    total normal force, repulsion positive                  [N]
 *   n, h   unit normal from j to i now and half a step ago         [1]
 *
 * Sliding: F_t keeps the direction of spring and dashpot together and gets the length mu max(F_n, 0); the spring is
 * cut to xi = -F_t/k_t, so that it holds the friction and nothing else. (Cut to -(F_t + eta_t s)/k_t, as often seen,
 * it loses 3 to 11 % of the friction impulse of a sliding impact; with mu |F_n| the pulling end of a damped impact
 * adds 7 %.)
 *
 * Carrying the spring into the new contact plane: positions move with the half-step velocity, r_new = r_old + dt v,
 * so h = unit(r_new - dt v/2) points along r_old + r_new and halves the angle between n_old and n when |r| is kept.
 * The mirror at the plane normal to h, xi - 2 (h.xi) h, maps n_old to -n, hence the plane normal to n_old to that
 * normal to n; in these planes it is the smallest rotation that takes n_old to n, and it keeps every length. Then
 * dt s is added and what points along n (second order in dt: s lies normal to h, and |r| changes a little) is taken
 * off. Where h = n (flat walls), mirror and cut together are a plain projection.
 *
 * Source: Mindlin, J. Appl. Mech. 16 (1949) 259 (stiffness without micro-slip), in the secant form of Kasuga, Discrete
 * element method (in Japanese, 2012), eqs. (15) to (23); friction: Coulomb. Changed from Kasuga's note:
 *   (17)       slip is v_t - (R_i w_i + R_j w_j) x n: with n from j to i the contact point of i is at -R_i n (done by
 *              who fills s); (22), (23) need the same sign, torque -R_i n x F_t. The two errors of sign cancel in
 *              every velocity, only the spin comes out reversed.
 *   (18)       d is the positive overlap; the note's delta is negative in contact and has no root.
 *   (20), (21) the direction of friction is that of the trial force, not of the slip (which reverses before the force
 *              does, and is 0/0 at rest); the limit counts no pulling; the spring is cut.
 * The secant law gives back up to 0.06 % more tangential speed than it took (elastic impact within 3 degrees of
 * normal), because k_t shrinks with d while xi stays.
 * Not here: partial slip and its loading history; turning of the spring with a common spin about n; rolling.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "base/math.h"

struct mindlin
{
    double friction;
    int damping;
    double modulus;                                       /* Pa   8 G*, derived */
};

static const struct dem_field settings[] = {
    DEM_FIELD(mindlin, friction, "1", DEM_FIELD_REQUIRED, 0.0, 100.0, "tangential force limit per normal force"),
    DEM_FIELD_SWITCH(mindlin, damping, "tangentialDamping", 1,
                     "damp slip with the coefficient of the normal law as long as the contact sticks"),
    {0},
};

static const char *const memory[] = {"shear_x", "shear_y", "shear_z", NULL};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    DEM_REQUIRE(pair->exponent > 0.0, DEM_ERROR_INPUT,
                "mindlin between %s and %s: there is no normal law to rub under; add one to the effects, hertz for example",
                pair->a->name, pair->b->name);
    DEM_REQUIRE(pair->reduced_shear > 0.0 && pair->reduced_shear <= DBL_MAX, DEM_ERROR_INPUT,
                "mindlin between %s and %s: the reduced shear modulus is %g Pa, but must be above 0 and finite; "
                "check youngsModulus and poissonsRatio of both",
                pair->a->name, pair->b->name, pair->reduced_shear);
    ((struct mindlin *)of)->modulus = 8.0*pair->reduced_shear;
    return DEM_OK;
}

DEM_KERNEL
static void act(const void *of, struct dem_block *restrict b, dem_real *const *remembered)
{
    const struct mindlin *mindlin = of;
    const dem_real friction = mindlin->friction, modulus = mindlin->modulus, dt = b->dt;
    const dem_real damped = mindlin->damping ? 1.0 : 0.0;
    dem_real *restrict xi_x = remembered[0], *restrict xi_y = remembered[1], *restrict xi_z = remembered[2];

    for (int c = 0; c < b->n; c++)
    {
        const dem_real nx = b->nx[c], ny = b->ny[c], nz = b->nz[c];
        const dem_real hx = b->hx[c], hy = b->hy[c], hz = b->hz[c];
        const dem_real kt = modulus*sqrt(b->reduced_radius[c]*b->overlap[c]);
        const dem_real eta = damped*b->eta[c];

        /* carry last step's spring into today's plane and load it; what is left along n goes, of spring and slip */
        const dem_real twice = 2.0*(hx*xi_x[c] + hy*xi_y[c] + hz*xi_z[c]);
        const dem_real tilt = nx*b->sx[c] + ny*b->sy[c] + nz*b->sz[c];
        const dem_real sx = b->sx[c] - tilt*nx;
        const dem_real sy = b->sy[c] - tilt*ny;
        const dem_real sz = b->sz[c] - tilt*nz;
        const dem_real rx = xi_x[c] - twice*hx;
        const dem_real ry = xi_y[c] - twice*hy;
        const dem_real rz = xi_z[c] - twice*hz;
        const dem_real lean = nx*rx + ny*ry + nz*rz;
        const dem_real ex = rx - lean*nx + dt*sx;
        const dem_real ey = ry - lean*ny + dt*sy;
        const dem_real ez = rz - lean*nz + dt*sz;

        /* sticks or slides; rows apart slide with no force and keep no spring */
        const dem_real tx = -kt*ex - eta*sx;
        const dem_real ty = -kt*ey - eta*sy;
        const dem_real tz = -kt*ez - eta*sz;
        const dem_real size = sqrt(tx*tx + ty*ty + tz*tz);
        const dem_real limit = dem_pick(b->fn[c] > 0.0, friction*b->fn[c], 0.0);
        const dem_real keep = dem_pick(size < limit, 1.0, limit/dem_pick(size > 0.0, size, 1.0));
        const dem_real cut = keep/dem_pick(kt > 0.0, kt, 1.0);

        xi_x[c] = dem_pick(size < limit, ex, -cut*tx);
        xi_y[c] = dem_pick(size < limit, ey, -cut*ty);
        xi_z[c] = dem_pick(size < limit, ez, -cut*tz);
        b->kt[c] = kt;
        b->fx[c] += keep*tx;
        b->fy[c] += keep*ty;
        b->fz[c] += keep*tz;
    }
}

const struct dem_effect dem_mindlin = {
    .name = "mindlin",
    .says = "friction: a spring of 8 G* sqrt(R* d) in the contact plane that slips at mu F_n",
    .source = "Mindlin 1949; Coulomb",
    .stage = DEM_STAGE_TANGENT,
    .size = sizeof(struct mindlin),
    .settings = settings,
    .memory = memory,
    .prepare = prepare,
    .act = act,
};
