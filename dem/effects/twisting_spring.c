/*
 * twisting_spring.c -- a contact resists twisting about its normal like a spring that can slip.
 *
 *   M = (-k_w theta - c_w w_n) n,   |M| <= L max(F_n, 0),   k_w = 16/3 G_w a^3,   c_w = 2 zeta sqrt(k_w I),   I = 2/5 m* R*^2
 *
 *   M      moment on i, the opposite on j                          [N m]
 *   theta  angle of twisting, the integral of w_n                  [rad]  remembered
 *   w_n    relative spin (w_i - w_j).n                             [1/s]
 *   a      radius of the circle of contact, sqrt(R* d)             [m]
 *   G_w    1/G_w = sum 1/G, G = E/(2 (1 + nu)) of both partners    [Pa]
 *   F_n    total normal force, repulsion positive                  [N]
 *   L      lever of friction: 3 pi/16 mu a (Hertz's pressure), or mu R*                                           [m]
 *   mu     friction, a setting                                     [1]
 *   zeta   damping, a setting                                      [1]
 *
 * With the lever `contact`, mu is the coefficient of sliding friction: each ring of the circle slides under Hertz's
 * pressure, 2 pi int r^2 mu p(r) dr = 3 pi/16 mu a F_n. With `reduced`, mu R* stands for a roughness or a flat that is
 * larger than the circle of two spheres. k_w is the torsion of two elastic bodies bonded over the circle. It is computed
 * from the normal law's k_n as 4 (G_w/E*) k_n a^2, which is the same with hertz and goes on with any other normal law.
 *
 * I is the inertia of a sphere spinning on a wall, for which zeta = 1 is critical; two equal spheres have 4 times
 * that and are damped by zeta/2.
 *
 * Source: torsion: Reissner and Sagoci, J. Appl. Phys. 15 (1944) 652; Lubkin, J. Appl. Mech. 18 (1951) 183; as a contact
 * law: Marshall, J. Comput. Phys. 228 (2009) 1541. Changed from Marshall: k_w is the elastic one and not k_t a^2/2, and
 * the limit 3 pi/16 of Hertz's pressure and not 2/3 of an even one.
 * Not here: slip and twist that share one limit of friction; slip that begins at the rim.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "base/math.h"
#include "effects/slider.h"

struct twisting_spring
{
    double friction;
    int lever;
    double damping;
    double ratio;                                         /* 1    k_w per k_n a^2, derived */
};

enum
{
    CONTACT,
    REDUCED
};
static const char *const levers[] = {"contact", "reduced", NULL};

static const struct dem_field settings[] = {
    DEM_FIELD(twisting_spring, friction, "1", DEM_FIELD_REQUIRED, 0.0, 100.0, "coefficient of friction at the lever's end"),
    DEM_FIELD_CHOICE(twisting_spring, lever, "lever", CONTACT, levers,
                     "largest moment per friction F_n: 3 pi/16 of the radius of contact, or the reduced radius"),
    DEM_FIELD(twisting_spring, damping, "1", 0.0, 0.0, 1.0, "of a sphere twisting to and fro on a plane, 1 is critical"),
    {0},
};

static const char *const memory[] = {"twist", NULL};

/* Pa; a rigid partner has an infinite modulus and adds nothing */
static double torsion_modulus(const struct dem_material *a, const struct dem_material *b)
{
    return 1.0/(2.0*(1.0 + a->poissons_ratio)/a->youngs_modulus + 2.0*(1.0 + b->poissons_ratio)/b->youngs_modulus);
}

static int prepare(void *of, const struct dem_pair_class *pair)
{
    DEM_REQUIRE(pair->exponent > 0.0, DEM_ERROR_INPUT,
                "twistingSpring between %s and %s: there is no normal law to twist under; add one to the effects, hertz for "
                "example", pair->a->name, pair->b->name);
    ((struct twisting_spring *)of)->ratio = 4.0*torsion_modulus(pair->a, pair->b)/pair->reduced_modulus;
    return DEM_OK;
}

DEM_KERNEL
static void act(const void *of, struct dem_block *restrict b, dem_real *const *remembered)
{
    const struct twisting_spring *twisting = of;
    const dem_real friction = twisting->friction, ratio = twisting->ratio, twice_zeta = 2.0*twisting->damping, dt = b->dt;
    const dem_real often = dem_slider_often(b);
    const dem_real by_contact = twisting->lever == CONTACT ? 0.58904862254808623 : 0.0;    /* 3 pi/16 */
    const dem_real by_radius = twisting->lever == REDUCED ? 1.0 : 0.0;
    dem_real *restrict twist = remembered[0];

    for (int c = 0; c < b->n; c++)
    {
        const dem_real R = b->reduced_radius[c], a2 = R*b->overlap[c];
        const dem_real lever = by_contact*sqrt(a2) + by_radius*R;
        const dem_real stiffness = ratio*b->kn[c]*a2;
        const dem_real damping = twice_zeta*R*sqrt(0.4*b->reduced_mass[c]*stiffness);
        const dem_real rate = b->wx[c]*b->hx[c] + b->wy[c]*b->hy[c] + b->wz[c]*b->hz[c];

        /* holds or slips, as in slider.h */
        const dem_real angle = twist[c] + dt*rate;
        const dem_real trial = -stiffness*angle - damping*rate, size = fabs(trial);
        const dem_real limit = dem_pick(b->fn[c] > 0.0, friction*lever*b->fn[c], 0.0);
        const dem_real moment = dem_pick(size < limit, 1.0, limit/dem_pick(size > 0.0, size, 1.0))*trial;
        const dem_real gives = stiffness + damping*often, slipped = (moment - trial)/dem_pick(gives > 0.0, gives, 1.0);

        twist[c] = dem_pick(limit > 0.0, dem_pick(size < limit, angle, angle - slipped), 0.0);
        b->mx[c] += moment*b->nx[c];
        b->my[c] += moment*b->ny[c];
        b->mz[c] += moment*b->nz[c];
    }
}

/* as slider.h has it, of an angle */
static void energy(const void *of, const struct dem_block *restrict b, dem_real *const *before, dem_real *const *memory,
                   struct dem_energy *restrict e)
{
    const struct twisting_spring *twisting = of;
    const dem_real *const from = before[0], *const to = memory[0], often = dem_slider_often(b);

    for (int c = 0; c < b->n; c++)
    {
        const dem_real R = b->reduced_radius[c], stiffness = b->touching[c]*twisting->ratio*b->kn[c]*R*b->overlap[c];
        const dem_real was = twisting->ratio*e->kn_was[c]*R*e->was[c];
        const dem_real rate = b->wx[c]*b->hx[c] + b->wy[c]*b->hy[c] + b->wz[c]*b->hz[c], slipped = from[c] + b->dt*rate - to[c];
        const dem_real damping = 2.0*twisting->damping*R*sqrt(0.4*b->reduced_mass[c]*stiffness);
        const dem_real dashpot = dem_pick(b->fn[c] > 0.0, damping*often*(to[c] - from[c]), 0.0);
        const dem_real damped = dashpot*(rate - 0.5*b->dt*(stiffness*to[c] + dashpot)/e->inertia[c])*b->dt;

        e->stored[c] = 0.5*stiffness*to[c]*to[c];
        e->lost[c] = damped + 0.5*(was*from[c] + stiffness*to[c])*slipped - 0.5*(stiffness - was)*from[c]*to[c];
    }
}

const struct dem_effect dem_twisting_spring = {
    .name = "twistingSpring",
    .says = "resistance to twisting about the normal: the torsion of the contact, which slips",
    .source = "Reissner and Sagoci 1944; Lubkin 1951; Marshall 2009",
    .stage = DEM_STAGE_MOMENT,
    .needs = DEM_NEEDS_SPIN,
    .size = sizeof(struct twisting_spring),
    .settings = settings,
    .memory = memory,
    .prepare = prepare,
    .act = act,
    .energy = energy,
};
