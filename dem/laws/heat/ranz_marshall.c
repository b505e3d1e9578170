/*
 * ranz_marshall.c -- heat transfer between fluid and particle of Ranz and Marshall: single sphere.
 *
 *   Nu = 2 + 0.6 Re^(1/2) Pr^(1/3)
 *
 *   Nu, Pr   Nusselt and Prandtl number, see heat_transfer.h         [1]
 *   Re       rho d |u - v|/mu, u interstitial, without the void fraction    [1]
 *
 * Independent of the void fraction, as schillerNaumann is. Measured on drops, Re up to 200, and used up
 * to about 1e4.
 *
 * Source: Ranz and Marshall, Chem. Eng. Prog. 48 (1952) 141, 173.
 * Not here: neighbours (see gunn, wakao).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/heat/heat.h"
#include "laws/heat/ranz_marshall.h"

#define LAW dem_ranz_marshall
#define SCALARS DEM_HEAT_SCALARS
#define SETS DEM_SETS_EXCHANGE
#include "laws/body_loop.h"

const struct dem_effect dem_ranz_marshall = {
    .name = "ranzMarshall",
    .aliases = "RanzMarshall Ranz-Marshall",
    .summary = "heat transfer between fluid and a single sphere, for dilute flow",
    .source = "Ranz and Marshall 1952",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_GRAINS,
    .needs = DEM_NEEDS_FLUID,
    .transfers = &dem_temperature,
    .scalars = dem_heat_transfer_scalars,
    .apply_to_bodies = apply_to_bodies,
};
