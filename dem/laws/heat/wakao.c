/*
 * wakao.c -- heat transfer between fluid and particle of Wakao and Kaguei: packed bed.
 *
 *   Nu = 2 + 1.1 Re^0.6 Pr^(1/3)
 *
 *   Nu, Pr   Nusselt and Prandtl number, see heat_transfer.h         [1]
 *   Re       superficial Reynolds number, e rho d |u - v|/mu         [1]
 *   e        void fraction                                           [1]
 *
 * Fitted to packed beds, e about 0.4, for Re from 15 to 8500.
 *
 * Source: Wakao and Kaguei, Heat and Mass Transfer in Packed Beds (1982).
 * Not here: dilute flow (see gunn, ranzMarshall).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/heat/heat.h"
#include "laws/heat/wakao.h"

#define LAW dem_wakao
#define SCALARS DEM_HEAT_SCALARS
#define SETS DEM_SETS_EXCHANGE
#include "laws/body_loop.h"

const struct dem_effect dem_wakao = {
    .name = "wakao",
    .aliases = "Wakao WakaoKaguei",
    .summary = "heat transfer between fluid and particles of a packed bed",
    .source = "Wakao and Kaguei 1982",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_GRAINS,
    .needs = DEM_NEEDS_FLUID,
    .transfers = &dem_temperature,
    .scalars = dem_heat_transfer_scalars,
    .apply_to_bodies = apply_to_bodies,
};
