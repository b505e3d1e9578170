/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaged/demRun.C"
#include "averaged/fluidBudget.C"
