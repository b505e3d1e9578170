/*
 * parcels.h -- parcels: particles that stand for several grains each, and the rule of a law for them.
 *
 *   D = l d,   n = l^3
 *
 *   l    ratio of a parcel, the particle scalar parcelRatio        [1]
 *   D    diameter of the parcel, which is the particle of the run  [m]
 *   d    diameter of the grain                                     [m]
 *   n    grains of a parcel; both have the same density and velocity [1]
 *
 * Contacts of parcels are similar to contacts of grains: lengths and times are l times, forces l^2
 * times as large; speeds, stresses and overlap over diameter are the same. On n grains the fluid
 * acts n times as on one. Each law states its rule in the member `parcels` of its descriptor; a law
 * without a rule is refused in a scene of parcels. docs/parcels.md derives the rules.
 *
 * Source: Bierwisch, Kraft, Riedel, Moseler, J. Mech. Phys. Solids 57 (2009) 10 (contacts); Sakai and
 * Koshizuka, Chem. Eng. Sci. 64 (2009) 533 (fluid).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/error.h"
#include "laws/effect.h"

/* l of a particle; constant. */
extern const struct dem_scalar dem_parcel_ratio;

/* In `prepare` of a law whose rule is DEM_PARCELS_SETTINGS: multiply a setting by l^power. A law has
   one setting for all contacts, so all parcels must have the same l; a setting of 0 needs none. */
static inline int dem_parcels_scale(const struct dem_pair_class *pair, const char *effect,
                                    const char *setting, int power, double *value)
{
    if (pair->max_parcel_ratio == 0.0 || *value == 0.0)
    {
        return DEM_OK;
    }
    DEM_REQUIRE(pair->min_parcel_ratio == pair->max_parcel_ratio, DEM_ERROR_INPUT,
                "%s: %s is multiplied by the ratio of the parcels, which is %g to %g; give all "
                "parcels the same parcelRatio, or choose another law",
                effect, setting, pair->min_parcel_ratio, pair->max_parcel_ratio);
    for (int k = 0; k < power; k++)
    {
        *value *= pair->max_parcel_ratio;
    }
    return DEM_OK;
}
