/*
 * viscosity.h -- viscosity of the fluid at a particle, a particle scalar.
 *
 * A scene has it when an effect takes the viscosity of a fluid: drag laws, damping by the Stokes
 * number, ... It comes from the entry `fluid` of the scene, or the coupled program writes it before
 * each window. Laws read it in the column `viscosity` of their batch; at a contact it is the mean of
 * both partners.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/scalar.h"

extern const struct dem_scalar dem_fluid_viscosity;
