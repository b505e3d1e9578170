/*
 * temperature.c -- the particle scalar temperature.
 *
 *   m c dT/dt = sum of heat rates
 *
 * A particle has one temperature: its Biot number must be small (docs/heat.md).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/heat/heat.h"

static double heat_capacity(const struct dem_material *m)
{
    return m->thermal.heat_capacity;
}

static const char *const exchange[DEM_SCALAR_COLUMNS] = DEM_SCALAR_EXCHANGE_NAMES("temperature");

const struct dem_scalar dem_temperature = {
    .name = "temperature",
    .unit = "K",
    .default_value = 293.15,
    .min = DEM_ABOVE_ZERO,
    .max = 1e5,
    .help = "temperature of a particle",
    .flags = DEM_SCALAR_PARTNERS | DEM_SCALAR_RATE | DEM_SCALAR_WRITTEN | DEM_SCALAR_HEAT,
    .capacity = heat_capacity,
    .capacity_entry = "heatCapacity",
    .exchange = exchange,
};

const struct dem_scalar *const dem_temperature_only[] = {&dem_temperature, NULL};
