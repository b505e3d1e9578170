/*
 * heat_transfer.h -- what the laws of heat transfer between fluid and particle share on a row.
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
#pragma once

#include "laws/fluid/drag.h"

enum    /* the scalars of a law, dem_heat_transfer_scalars */
{
    DEM_HEAT_TEMPERATURE,
    DEM_HEAT_FLUID_TEMPERATURE,
    DEM_HEAT_CONDUCTIVITY,
    DEM_HEAT_CAPACITY,
    DEM_HEAT_SCALARS
};

/* Pr^(1/3); 0 where there is no conductivity */
DEM_MATH double dem_heat_prandtl_root(const struct dem_body_row *r)
{
    const double k = r->scalars[DEM_HEAT_CONDUCTIVITY].value,
                 conducts = dem_select(k > 0.0, 1.0, 0.0);

    return dem_pow(conducts*r->viscosity*r->scalars[DEM_HEAT_CAPACITY].value/
                       dem_select(k > 0.0, k, 1.0),
                   1.0/3.0);
}

/* Heat transfer of a row by its Nu: coefficient and target. */
DEM_MATH void dem_heat_transfer_add(struct dem_body_row *r, double nusselt)
{
    /* pi d k_f Nu */
    const double B = 3.14159265358979324*(2.0*r->radius)*r->scalars[DEM_HEAT_CONDUCTIVITY].value*
                     nusselt;

    r->scalars[DEM_HEAT_TEMPERATURE].coefficient += B;
    r->scalars[DEM_HEAT_TEMPERATURE].to_target += B*r->scalars[DEM_HEAT_FLUID_TEMPERATURE].value;
}
