/*
 * heat_transfer.h -- what the laws of heat transfer between fluid and particle share.
 *
 *   Q = B (T_f - T),   B = h pi d^2,   h = Nu k_f/d,   Pr = mu c_f/k_f
 *
 *   Q          heat rate into the particle                             [W]
 *   B, h       coefficient of a particle; of its surface               [W/K], [W/(m2 K)]
 *   Nu, Pr     Nusselt and Prandtl number; a law is a function Nu      [1]
 *   T_f, k_f, c_f   temperature, conductivity, specific heat capacity of the fluid at the particle
 *                                                                      [K], [W/(m K)], [J/(kg K)]
 *   mu, d      viscosity of the fluid, diameter                        [Pa s], [m]
 *
 * The step integrates B exactly (laws/scalar.h): T tends to T_f and never past it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_HEAT_TRANSFER_H
#define DEM_LAWS_HEAT_TRANSFER_H

#include "laws/fluid/drag.h"
#include "laws/heat/heat.h"

/* The list of a law: temperature, and the fluid's temperature, conductivity, heat capacity. */
extern const struct dem_scalar *const dem_heat_transfer_scalars[];

struct dem_heat_transfer    /* columns of a batch, in the order of the list */
{
    double *coefficient, *to_target;
    const double *fluid_temperature, *conductivity, *heat_capacity;
};

static inline struct dem_heat_transfer dem_heat_transfer_of(const struct dem_body_batch *b)
{
    return (struct dem_heat_transfer){.coefficient = b->scalars[0].coefficient,
                                      .to_target = b->scalars[0].to_target,
                                      .fluid_temperature = b->scalars[1].value,
                                      .conductivity = b->scalars[2].value,
                                      .heat_capacity = b->scalars[3].value};
}

/* Pr^(1/3); 0 where there is no conductivity */
DEM_MATH double dem_heat_prandtl_root(const struct dem_body_batch *b,
                                      const struct dem_heat_transfer *t, int c)
{
    const double k = t->conductivity[c], conducts = dem_select(k > 0.0, 1.0, 0.0);

    return dem_pow(conducts*b->viscosity[c]*t->heat_capacity[c]/dem_select(k > 0.0, k, 1.0),
                   1.0/3.0);
}

#endif
