/*
 * viscous.c -- a dashpot of given strength in every contact.
 *
 *   F_n = ... - c v_n
 *
 *   v_n  normal relative speed, negative on approach               [m/s]
 *   c    damping coefficient, a setting                            [kg/s]
 *
 * With hooke an impact on a spring k lasts pi/sqrt(k/m* - c^2/4 m*^2) and returns e = exp(-pi z/sqrt(1 - z^2)),
 * z = c/(2 sqrt(k m*)), whatever its speed; with hertz e falls as the speed does, for the spring is softer then.
 * That holds if the dashpot may pull at the end, which is the default. Clamped, e is larger: see dry.
 *
 * Longest step: a fifth of m/c, the time in which the dashpot alone stops the least pair.
 *
 * Source: Cundall and Strack, Geotechnique 29 (1979) 47.
 * Not here: a coefficient for a given restitution (see dry).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "effects/restitution.h"

struct viscous
{
    double coefficient;
    int attraction;
};

static const struct dem_field settings[] = {
    DEM_FIELD(viscous, coefficient, "kg/s", DEM_FIELD_REQUIRED, 0.0, INFINITY, "force per normal speed"),
    DEM_FIELD_CHOICE(viscous, attraction, "attraction", DEM_ATTRACTION_ALLOWED, dem_attractions,
                     "whether the dashpot may pull when a contact opens; clamped it bounces higher, see dry"),
    {0},
};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    (void)of;
    DEM_REQUIRE(pair->exponent > 0.0, DEM_ERROR_INPUT,
                "viscous between %s and %s: there is no normal law to damp; add one to the effects, hooke for example",
                pair->a->name, pair->b->name);
    return DEM_OK;
}

static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    const double c = ((const struct viscous *)of)->coefficient;

    *why = "a fifth of mass over the coefficient of viscous";
    return c > 0.0 ? 0.2*pair->least_mass/c : DBL_MAX;
}

DEM_KERNEL
static void act(const void *of, struct dem_block *restrict b, dem_real *const *memory)
{
    const struct viscous *viscous = of;
    const dem_real coefficient = viscous->coefficient, least = dem_attraction_least(viscous->attraction);

    (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        const dem_real eta = coefficient*b->touching[c];

        b->eta[c] = eta;
        b->fn[c] = dem_attraction(b->fn[c], eta*b->vn[c], least);
    }
}

static void energy(const void *of, const struct dem_block *restrict b, dem_real *const *before, dem_real *const *memory,
                   struct dem_energy *restrict e)
{
    (void)of, (void)before, (void)memory;
    dem_restitution_energy(b, e);
}

const struct dem_effect dem_viscous = {
    .name = "viscous",
    .says = "viscous damping with a given coefficient, -c v_n",
    .source = "Cundall and Strack 1979",
    .stage = DEM_STAGE_DAMP,
    .size = sizeof(struct viscous),
    .settings = settings,
    .prepare = prepare,
    .time_limit = time_limit,
    .act = act,
    .energy = energy,
};
