/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "exchange/demCouplingScheme.C"
#include "exchange/demUnderRelaxation.C"
#include "exchange/demMomentumBalance.C"
#include "exchange/demFlowQuantities.C"
#include "exchange/demOwnWake.C"
#include "exchange/demExchange.C"
#include "exchange/demHeatExchange.C"
#include "exchange/demParticleBudget.C"
