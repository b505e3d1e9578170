/*
 * friction_effect.h -- what the descriptors of the friction laws share: settings.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/contact/friction.h"
#include "laws/effect.h"

#define DEM_FRICTION_SETTING(type)                                                             \
    DEM_SETTING_AS(type, common.friction, "friction", "1", DEM_SETTING_REQUIRED, 0.0, 100.0,   \
                   "mu: limit of the tangential over the normal force")

#define DEM_FRICTION_SWITCHES(type)                                                            \
    DEM_SETTING_SWITCH(type, common.damping, "tangentialDamping", 1,                           \
                       "dashpot with the coefficient of the normal law, while sticking"),      \
    DEM_SETTING_SWITCH(type, common.adhesion, "adhesion", 1,                                   \
                       "limit mu (F_n + 2 F_c) with jkr, mu (F_n + k_c d) with hookeHysteresis")

/* 8 G* of a class [Pa], for the law of this name; an error without a normal law or shear moduli. */
int dem_mindlin_modulus(const char *law, const struct dem_pair_class *, double *modulus);
