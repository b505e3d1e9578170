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
 *   T_R/5,    T_R = pi R sqrt(rho/G)/(0.1631 nu + 0.8766)          a surface wave runs round half a particle (impact.h)
 *
 *   m*   reduced mass                                              [kg]
 *   v    impact speed, a setting                                   [m/s]
 *   2.8683 = 4 sqrt(pi) Gamma(2/5)/(5 Gamma(9/10)) (15/16)^(2/5)
 *
 * A stiffness in place of 4/3 E* may be given; then there is no wave to resolve.
 *
 * Source: Hertz, J. reine angew. Math. 92 (1882) 156; duration: Johnson, Contact Mechanics (1985), section 11.4. At
 * 1/20 an elastic impact keeps its speed within 0.1 %. Eqs. (6), (7), (10), (11) of Kasuga, Discrete element method (in
 * Japanese, 2012) are this; changed: d is the positive overlap, for the note's delta of (7) is negative in contact and
 * has no root in (10).
 * Not here: damping (see dry, stokes), friction (see mindlin), plastic contact, adhesion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "effects/hertz.h"
#include "effects/impact.h"

static const struct dem_field settings[] = {
    DEM_FIELD_AS(dem_hertz, impact_speed, "impactSpeed", "m/s", 1.0, DEM_ABOVE_ZERO, INFINITY,
                 "fastest impact to be resolved; bounds the time step, not the force"),
    DEM_FIELD(dem_hertz, stiffness, "Pa", 0.0, 0.0, INFINITY, 
              "in place of 4/3 E*: F_n = stiffness sqrt(R*) d^(3/2); 0: from the materials"),
    {0},
};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct dem_hertz *const hertz = of;

    hertz->modulus = hertz->stiffness;
    if (hertz->stiffness == 0.0)
    {
        DEM_TRY(dem_impact_elastic("hertz", pair));
        hertz->modulus = 4.0/3.0*pair->reduced_modulus;
    }
    return DEM_OK;
}

/* Pa: E*, or what stands for it where a stiffness is given */
static double modulus_of(const struct dem_hertz *hertz, const struct dem_pair_class *pair)
{
    return hertz->stiffness > 0.0 ? 0.75*hertz->stiffness : pair->reduced_modulus;
}

static double contact_time(const void *of, const struct dem_pair_class *pair)
{
    const struct dem_hertz *const hertz = of;
    const double over = pair->least_mass/modulus_of(hertz, pair);

    return 2.8682657*dem_pow(over*over/(pair->least_radius*hertz->impact_speed), 0.2);
}

/* the text stays until this thread asks again */
static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    static _Thread_local char text[160];

    const struct dem_hertz *const hertz = of;
    const double contact = contact_time(of, pair);

    const char *whose;
    const double wave = dem_impact_rayleigh(pair, &whose);

    *why = text;
    if (hertz->stiffness > 0.0 || 0.05*contact <= wave)
    {
        snprintf(text, sizeof text, "1/20 of the Hertz contact time of %s-%s at %g m/s", pair->a->name, pair->b->name,
                 hertz->impact_speed);
        return 0.05*contact;
    }
    snprintf(text, sizeof text, "0.2 of the Rayleigh time of %s", whose);
    return wave;
}

DEM_KERNEL
static void act(const void *of, struct dem_block *restrict b, dem_real *const *memory)
{
    const dem_real modulus = ((const struct dem_hertz *)of)->modulus;

    (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        struct dem_row r = dem_row_at(b, c);

        dem_hertz_row(modulus, &r);
        b->kn[c] = r.kn;
        b->fn[c] = r.fn;
    }
}

/* 2/5 F_n d */
static void energy(const void *of, const struct dem_block *restrict b, dem_real *const *before, dem_real *const *memory,
                   struct dem_energy *restrict e)
{
    (void)of, (void)before, (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        e->stored[c] = b->touching[c]*0.4*b->kn[c]*b->overlap[c]*b->overlap[c];
    }
}

const struct dem_effect dem_hertz = {
    .name = "hertz",
    .says = "elastic repulsion of smooth spheres, F_n = 4/3 E* sqrt(R*) d^(3/2)",
    .source = "Hertz 1882",
    .stage = DEM_STAGE_NORMAL,
    .exponent = 1.5,
    .size = sizeof(struct dem_hertz),
    .settings = settings,
    .prepare = prepare,
    .time_limit = time_limit,
    .contact_time = contact_time,
    .act = act,
    .energy = energy,
};
