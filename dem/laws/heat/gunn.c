/*
 * gunn.c -- heat transfer between fluid and particle of Gunn: single sphere to packed bed.
 *
 *   Nu = (7 - 10 e + 5 e^2) (1 + 0.7 Re^0.2 Pr^(1/3)) + (1.33 - 2.4 e + 1.2 e^2) Re^0.7 Pr^(1/3)
 *
 *   Nu, Pr   Nusselt and Prandtl number, see heat_transfer.h         [1]
 *   e        void fraction                                           [1]
 *   Re       superficial Reynolds number, e rho d |u - v|/mu         [1]
 *
 * At rest Nu is 2 for a single sphere and 3.8 in a bed of e = 0.4. Fitted for e from 0.35 to 1 and Re
 * up to 1e5.
 *
 * Source: Gunn, Int. J. Heat Mass Transfer 21 (1978) 467.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/heat/gunn.h"
#include "laws/heat/heat.h"

#define LAW dem_gunn
#define SCALARS DEM_HEAT_SCALARS
#define SETS DEM_SETS_EXCHANGE
#include "laws/body_loop.h"

const struct dem_effect dem_gunn = {
    .name = "gunn",
    .aliases = "Gunn heatTransferGunn",
    .summary = "heat transfer between fluid and particles, single sphere to packed bed",
    .source = "Gunn 1978",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_GRAINS,
    .needs = DEM_NEEDS_FLUID,
    .transfers = &dem_temperature,
    .scalars = dem_heat_transfer_scalars,
    .apply_to_bodies = apply_to_bodies,
};
