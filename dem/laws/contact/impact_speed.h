/*
 * impact_speed.h -- linear spring for a given impact speed, and time step limits of normal laws.
 *
 *   k = 16/15 E* sqrt(R*) (15 m* v^2/(16 E* sqrt(R*)))^(1/5)
 *
 *   k    stiffness of the linear spring whose largest overlap in an impact at v is as with Hertz's
 *        law                                                       [N/m]
 *   E*   reduced modulus                                           [Pa]
 *   R*   reduced radius                                            [m]
 *   m*   reduced mass                                              [kg]
 *   v    characteristic speed                                      [m/s]
 *
 * Computed with one power of what differs between contacts:
 * k = K (R*^2 m*)^(1/5), K = (16/15 E*)^(4/5) v^(2/5).
 *
 * Limits of the time step:
 *
 *   t_c/20   t_c = pi sqrt(m/k), duration of an impact on a linear spring
 *   T_R/5    T_R = pi R sqrt(rho/G)/(0.1631 nu + 0.8766), Rayleigh time: a surface wave travels
 *            around half a particle
 *
 *   R    radius of the smallest particle: R* at a wall, 2 R* in a pair (two equal ones are assumed)
 *
 * With added mass (virtualMass in a fluid of known density) m* contains it, and rho is the density of
 * the particle plus C times the fluid's: this is the inertia that moves. With friction, rolling
 * resistance, bonds or films added mass does not count: they turn particles, and the moment of
 * inertia of a sphere contains none.
 *
 * At t_c/20 the frequency of the spring is 0.10 % too high (pi^2/(24 20^2)), at three times that
 * 0.95 %. T_R/5 is the smaller limit for impacts so slow that t_c > 4 T_R, and there it is strict
 * as far as single contacts go: for an impact at 1/250 of the speed where both are equal, three
 * times T_R/5 still keeps the speed within 0.05 %.
 *
 * Source: k: eq. (1) of Open DEM Japan, Hooke/Hysteresis normal contact model (in Japanese, 2025).
 * Rayleigh time: Thornton and Randall in Micromechanics of Granular Materials (1988) 133. The
 * fractions 1/20 and 1/5 are common practice, not theory.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/math.h"
#include "laws/contact/impact_spring.h"
#include "laws/effect.h"

#include <stdio.h>

/* s: Rayleigh time of a particle of this material and radius; added_density: of a pair class */
static inline double dem_impact_rayleigh_time(const struct dem_material *particle, double radius,
                                              double added_density)
{
    const double nu = particle->poissons_ratio;
    const double shear = particle->youngs_modulus/(2.0*(1.0 + nu));

    return 3.14159265358979324*radius*sqrt((particle->density + added_density)/shear)/(0.1631*nu + 0.8766);
}

/* s: 1/5 of the smaller Rayleigh time of the pair class; *material: name of the material that
   has it */
static inline double dem_impact_rayleigh_limit(const struct dem_pair_class *pair,
                                               const char **material)
{
    const double radius = pair->with_wall ? pair->min_radius : 2.0*pair->min_radius;
    const double wave_a = dem_impact_rayleigh_time(pair->a, radius, pair->added_density);
    const double wave_b =
        pair->with_wall ? wave_a
                        : dem_impact_rayleigh_time(pair->b, radius, pair->added_density);

    *material = wave_b < wave_a ? pair->b->name : pair->a->name;
    return 0.2*(wave_b < wave_a ? wave_b : wave_a);
}

/* Error if the pair class has no elastic modulus; `effect`: name for the message. */
static inline int dem_impact_require_modulus(const char *effect, const struct dem_pair_class *pair)
{
    DEM_REQUIRE(
        pair->reduced_modulus > 0.0 && pair->reduced_modulus <= DBL_MAX, DEM_ERROR_INPUT,
        "%s between %s and %s: the reduced modulus is %g Pa, but must be above 0 and finite; "
        "check youngsModulus and poissonsRatio of both",
        effect, pair->a->name, pair->b->name, pair->reduced_modulus);
    return DEM_OK;
}

static inline int dem_impact_prepare(struct dem_impact_spring *spring, const char *effect,
                                     const struct dem_pair_class *pair)
{
    if (spring->stiffness > 0.0)
    {
        spring->scale = 0.0;
        return DEM_OK;
    }
    DEM_TRY(dem_impact_require_modulus(effect, pair));
    spring->scale = dem_pow(16.0/15.0*pair->reduced_modulus, 0.8)*dem_pow(spring->speed, 0.4);
    return DEM_OK;
}

/* s: duration of an impact of the smallest particles on `factor` times the stiffness */
static inline double dem_impact_contact_time(const struct dem_impact_spring *spring, double factor,
                                             const struct dem_pair_class *pair)
{
    const double m = pair->min_mass, R = pair->min_radius;
    const double k = spring->scale > 0.0 ? spring->scale*dem_pow(R*R*m, 0.2) : spring->stiffness;

    return 3.14159265358979324*sqrt(m/(factor*k));
}

/* s: largest time step of the pair class for `factor` times the stiffness; *why is valid until the
   next call in this thread */
static inline double dem_impact_time_limit(const struct dem_impact_spring *spring, double factor,
                                           const struct dem_pair_class *pair, const char **why)
{
    static _Thread_local char text[200];

    const double contact = 0.05*dem_impact_contact_time(spring, factor, pair),
                 unit = 20.0*contact/3.14159265358979324;
    const char *material;
    const double wave = dem_impact_rayleigh_limit(pair, &material);

    *why = text;
    if (spring->scale > 0.0 && wave < contact)
    {
        snprintf(text, sizeof text, "0.2 of the Rayleigh time of %s", material);
        return wave;
    }
    snprintf(text, sizeof text, "1/20 of the contact time of %s-%s on a spring of %.3g N/m",
             pair->a->name, pair->b->name, pair->min_mass/(unit*unit));
    return contact;
}

/* Sets kn of all rows. Runs before the loop of a law, so that a given stiffness does not pay for the
   power function that a derived one needs. */
DEM_MATH void dem_impact_stiffnesses(const struct dem_impact_spring *spring,
                                     struct dem_contact_batch *restrict b)
{
    const struct dem_impact_spring s = *spring;

    if (s.scale > 0.0)
    {
        for (int c = 0; c < b->n; c++)
        {
            b->kn[c] = dem_impact_derived_stiffness(&s, b->touching[c], b->reduced_radius[c],
                                                    b->reduced_mass[c]);
        }
        return;
    }
    for (int c = 0; c < b->n; c++)
    {
        b->kn[c] = dem_impact_given_stiffness(&s, b->touching[c]);
    }
}
