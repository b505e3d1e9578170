/*
 * parcels.c -- the particle scalar parcelRatio.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/parcels.h"

const struct dem_scalar dem_parcel_ratio = {
    .name = "parcelRatio",
    .unit = "1",
    .default_value = DEM_SETTING_REQUIRED,
    .min = 1.0,
    .max = 1000.0,
    .help = "diameter of a parcel over the diameter of the grains it stands for",
    .flags = DEM_SCALAR_WRITTEN,
};
