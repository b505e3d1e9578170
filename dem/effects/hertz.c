/*
 * hertz.c -- smooth elastic spheres push each other apart as Hertz has it.
 *
 *   F_n = k_n d,    k_n = 4/3 E* sqrt(R* d)
 *
 *   d    overlap, R_i + R_j - |r|, positive in contact             [m]
 *   k_n  secant stiffness (the tangent one is 3/2 of it)           [N/m]
 *   R*   reduced radius, R_i R_j/(R_i + R_j); R_i at a wall        [m]
 *   E*   reduced modulus, 1/E* = sum (1 - nu^2)/E                  [Pa]
 *
 * Longest step: the lesser of
 *
 *   t_c/20,   t_c = 2.8683 (m*^2/(R* E*^2 v))^(1/5)                duration of an elastic impact at the speed v
 *   T_R/5,    T_R = pi R sqrt(rho/G)/(0.1631 nu + 0.8766)          a surface wave runs round half a particle
 *
 *   m*   reduced mass                                              [kg]
 *   v    impact speed, the only setting                            [m/s]
 *   2.8683 = 4 sqrt(pi) Gamma(2/5)/(5 Gamma(9/10)) (15/16)^(2/5)
 *   R    radius of the smallest particle: R* at a wall, and 2 R* in a pair, where two equal ones are assumed
 *
 * Source: Hertz, J. reine angew. Math. 92 (1882) 156; duration: Johnson, Contact Mechanics (1985), section 11.4.
 * Rayleigh time: Thornton and Randall in Micromechanics of Granular Materials (1988) 133. The fractions 1/20 and 1/5
 * are common practice, not theory: at 1/20 an elastic impact keeps its speed within 0.1 %.
 * Not here: damping (see dry, stokes), friction (see mindlin), plastic contact, adhesion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "base/math.h"

#include <stdio.h>

struct hertz
{
    double impact_speed;
    double modulus;                                       /* Pa   4/3 E*, derived */
};

static const struct dem_field settings[] = {
    DEM_FIELD_AS(hertz, impact_speed, "impactSpeed", "m/s", 1.0, DEM_ABOVE_ZERO, INFINITY,
                 "fastest impact to be resolved; bounds the time step, not the force"),
    {0},
};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    DEM_REQUIRE(pair->reduced_modulus > 0.0 && pair->reduced_modulus <= DBL_MAX, DEM_ERROR_INPUT,
                "hertz between %s and %s: the reduced modulus is %g Pa, but must be above 0 and finite; "
                "check youngsModulus and poissonsRatio of both",
                pair->a->name, pair->b->name, pair->reduced_modulus);
    ((struct hertz *)of)->modulus = 4.0/3.0*pair->reduced_modulus;
    return DEM_OK;
}

/* s: a surface wave of this particle runs round half of it */
static double rayleigh_time(const struct dem_material *particle, double radius)
{
    const double nu = particle->poissons_ratio;
    const double shear = particle->youngs_modulus/(2.0*(1.0 + nu));

    return 3.14159265358979324*radius*sqrt(particle->density/shear)/(0.1631*nu + 0.8766);
}

static double contact_time(const void *of, const struct dem_pair_class *pair)
{
    const double over = pair->least_mass/pair->reduced_modulus;

    return 2.8682657*dem_pow(over*over/(pair->least_radius*((const struct hertz *)of)->impact_speed), 0.2);
}

/* the text stays until this thread asks again */
static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    static _Thread_local char text[160];

    const double speed = ((const struct hertz *)of)->impact_speed;
    const double contact = contact_time(of, pair);

    const double radius = pair->with_wall ? pair->least_radius : 2.0*pair->least_radius;
    const double wave_a = rayleigh_time(pair->a, radius);
    const double wave_b = pair->with_wall ? wave_a : rayleigh_time(pair->b, radius);
    const double wave = wave_b < wave_a ? wave_b : wave_a;

    *why = text;
    if (0.05*contact <= 0.2*wave)
    {
        snprintf(text, sizeof text, "1/20 of the Hertz contact time of %s-%s at %g m/s", pair->a->name, pair->b->name,
                 speed);
        return 0.05*contact;
    }
    snprintf(text, sizeof text, "0.2 of the Rayleigh time of %s", wave_b < wave_a ? pair->b->name : pair->a->name);
    return 0.2*wave;
}

DEM_KERNEL
static void act(const void *of, struct dem_block *restrict b, dem_real *const *memory)
{
    const dem_real modulus = ((const struct hertz *)of)->modulus;

    (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        const dem_real kn = modulus*sqrt(b->reduced_radius[c]*b->overlap[c]);

        b->kn[c] = kn;
        b->fn[c] += kn*b->overlap[c];
    }
}

const struct dem_effect dem_hertz = {
    .name = "hertz",
    .says = "elastic repulsion of smooth spheres, F_n = 4/3 E* sqrt(R*) d^(3/2)",
    .source = "Hertz 1882",
    .stage = DEM_STAGE_NORMAL,
    .exponent = 1.5,
    .size = sizeof(struct hertz),
    .settings = settings,
    .prepare = prepare,
    .time_limit = time_limit,
    .contact_time = contact_time,
    .act = act,
};
