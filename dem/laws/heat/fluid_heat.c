/*
 * fluid_heat.c -- thermal values of the fluid at a particle: temperature, conductivity, heat capacity.
 *
 * They come from the entry `fluid` of the scene, or the coupled program writes them before each
 * window. They are constant over a window.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/heat/heat.h"

static const struct dem_scalar fluid_temperature = {
    .name = "fluidTemperature",
    .unit = "K",
    .max = 1e5,
    .help = "temperature of the fluid at the particle",
    .flags = DEM_SCALAR_WRITTEN,
    .fluid_entry = "temperature",
};

static const struct dem_scalar fluid_conductivity = {
    .name = "fluidConductivity",
    .unit = "W/(m K)",
    .max = 1e5,
    .help = "thermal conductivity of the fluid at the particle",
    .fluid_entry = "conductivity",
};

static const struct dem_scalar fluid_heat_capacity = {
    .name = "fluidHeatCapacity",
    .unit = "J/(kg K)",
    .max = 1e9,
    .help = "specific heat capacity of the fluid at the particle",
    .fluid_entry = "heatCapacity",
};

const struct dem_scalar *const dem_heat_transfer_scalars[] = {
    &dem_temperature, &fluid_temperature, &fluid_conductivity, &fluid_heat_capacity, NULL};
