/*
 * heat.h -- what the effects of heat share: the scalar temperature, and properties of pairs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/effect.h"

/* The temperature of a particle, uniform in it [K]; C = m c. */
extern const struct dem_scalar dem_temperature;

/* The list of an effect that needs the temperature only. */
extern const struct dem_scalar *const dem_temperature_only[];

/* The list of a law of heat transfer: temperature, and the fluid's temperature, conductivity, heat
   capacity. */
extern const struct dem_scalar *const dem_heat_transfer_scalars[];

/* Harmonic mean of the conductivities [W/(m K)]. */
static inline double dem_heat_conductivity(const struct dem_pair_class *pair)
{
    const double a = pair->a->thermal.conductivity, b = pair->b->thermal.conductivity;

    return 2.0*a*b/(a + b);
}

/* The smaller heat capacity of the particles of a pair [J/(kg K)]. */
static inline double dem_heat_min_capacity(const struct dem_pair_class *pair)
{
    const double a = pair->a->thermal.heat_capacity, b = pair->b->thermal.heat_capacity;

    return pair->with_wall || a < b ? a : b;
}

/* E* of the real materials [Pa]; without a real modulus, E* of the scene. */
static inline double dem_heat_real_modulus(const struct dem_pair_class *pair)
{
    const struct dem_material *const m[2] = {pair->a, pair->b};
    double compliance = 0.0;

    for (int k = 0; k < 2; k++)
    {
        const double real = m[k]->thermal.real_modulus;

        compliance += (1.0 - m[k]->poissons_ratio*m[k]->poissons_ratio)/
                      (real > 0.0 ? real : m[k]->youngs_modulus);
    }
    return 1.0/compliance;
}
