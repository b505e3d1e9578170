/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/demDrivingForce.C"
#include "fluid/demFluid.C"
#include "fluid/demFluidGradient.C"
