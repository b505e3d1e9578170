/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "functionObjects/demDriver.C"
#include "functionObjects/demThermoHeat.C"
#include "functionObjects/demMomentumSource.C"
#include "functionObjects/demEnergySource.C"
#include "functionObjects/demTurbulenceSource.C"
#include "functionObjects/demFunctionObject.C"
#include "functionObjects/demMeans.C"
