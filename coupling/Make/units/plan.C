/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "plan/demPlan.C"
#include "plan/demPlanBaffles.C"
#include "plan/demPlanStreams.C"
#include "plan/demPlanWarnings.C"
