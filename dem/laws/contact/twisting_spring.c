/*
 * twisting_spring.c -- torsional resistance: a rotational spring about the normal.
 *
 *   M = (-k_w theta - c_w w_n) n,   |M| <= L max(F_n, 0)
 *   k_w = 16/3 G_w a^3,   c_w = 2 zeta sqrt(k_w I),   I = 2/5 m* R*^2
 *
 *   M      moment on i, the opposite on j                          [N m]
 *   theta  twist angle, the integral of w_n (history)              [rad]
 *   w_n    relative spin (w_i - w_j).n                             [1/s]
 *   a      radius of the contact circle, sqrt(R* d)                [m]
 *   G_w    1/G_w = sum 1/G, G = E/(2 (1 + nu)) of both partners    [Pa]
 *   F_n    total normal force, repulsion positive                  [N]
 *   L      friction coefficient times lever arm: 3 pi/16 mu a (Hertz pressure), or mu R*       [m]
 *   mu     coefficient of friction, a setting                      [1]
 *   zeta   damping ratio, a setting                                [1]
 *
 * With the lever `contact`, mu is the coefficient of sliding friction: each ring of the circle
 * slides under the Hertz pressure, 2 pi int r^2 mu p(r) dr = 3 pi/16 mu a F_n. With `reduced`, mu
 * R* models a roughness or a flat that is larger than the contact circle of two spheres. k_w is the
 * torsional stiffness of two elastic bodies bonded over the circle. It is computed from k_n of the
 * normal law as 4 (G_w/E*) k_n a^2, which is the same with hertz and also defined for any other
 * normal law.
 *
 * I is the inertia of a sphere spinning on a wall, for which zeta = 1 is critical; two equal
 * spheres have 4 times that and are damped by zeta/2.
 *
 * Source: torsion: Reissner and Sagoci, J. Appl. Phys. 15 (1944) 652; Lubkin, J. Appl. Mech. 18
 * (1951) 183; as a contact law: Marshall, J. Comput. Phys. 228 (2009) 1541. Changed from Marshall:
 * k_w is the elastic stiffness, not k_t a^2/2, and the limit is 3 pi/16 for the Hertz pressure, not
 * 2/3 for a uniform one.
 * Not here: slip and twist under a common friction limit; slip that begins at the rim.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/contact/twisting_spring.h"
#include "laws/effect.h"

static const char *const levers[] = {"contact", "reduced", NULL};

static const struct dem_setting settings[] = {
    DEM_SETTING(dem_twisting_spring, friction, "1", DEM_SETTING_REQUIRED, 0.0, 100.0,
              "mu: coefficient of friction"),
    DEM_SETTING_CHOICE(dem_twisting_spring, lever, "lever", DEM_TWISTING_CONTACT, levers,
                     "largest moment over mu F_n: 3 pi/16 of the contact radius, or the reduced "
                     "radius"),
    DEM_SETTING(dem_twisting_spring, damping, "1", 0.0, 0.0, 1.0,
              "zeta: damping ratio of a sphere on a plane in torsional oscillation, 1 is critical"),
    {0},
};

static const char *const history_names[] = {"twist", NULL};

/* Pa: G_w; a rigid partner has an infinite modulus and adds nothing */
static double torsion_modulus(const struct dem_material *a, const struct dem_material *b)
{
    return 1.0/(2.0*(1.0 + a->poissons_ratio)/a->youngs_modulus +
                  2.0*(1.0 + b->poissons_ratio)/b->youngs_modulus);
}

static int prepare(void *of, const struct dem_pair_class *pair)
{
    ((struct dem_twisting_spring *)of)->ratio =
        4.0*torsion_modulus(pair->a, pair->b)/pair->reduced_modulus;
    return DEM_OK;
}

#define LAW dem_twisting_spring
#define COLUMNS dem_twisting_spring_columns
#define SETS DEM_SETS_MOMENT
#define ENERGY
#include "laws/contact_loop.h"

/* In use: its largest moment over R* mu F_n: 3 pi/16 sqrt(d/R*) mu_t/mu at the overlap d of an
   impact, or mu_t/mu. */
static int relevance(const void *of, const struct dem_regime *g, struct dem_relevance *v)
{
    const struct dem_twisting_spring *const twisting = of;

    if (!twisting)
    {
        return 0;
    }
    v->fraction =
        (twisting->lever == DEM_TWISTING_REDUCED ? 1.0 : 3.0*3.14159265358979324/16.0*sqrt(g->overlap))*
        twisting->friction /(g->friction > 0.0 ? g->friction : 1.0);
    v->quantity = "of the moment of friction resists twisting (Marshall 2009)";
    return 1;
}

const struct dem_effect dem_twisting_spring = {
    .name = "twistingSpring",
    .summary =
        "torsional resistance about the normal: the elastic torsion of the contact, which slips",
    .source = "Reissner and Sagoci 1944; Lubkin 1951; Marshall 2009",
    .stage = DEM_STAGE_MOMENT,
    .parcels = DEM_PARCELS_SAME,
    .needs = DEM_NEEDS_SPIN,
    .example = "friction 0.1;",
    .size = sizeof(struct dem_twisting_spring),
    .settings = settings,
    .history = history_names,
    .prepare = prepare,
    .apply = apply,
    .energy = energy,
    .relevance = relevance,
    .mechanism = DEM_MECHANISM_TWISTING,
};
