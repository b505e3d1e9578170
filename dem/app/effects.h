/*
 * effects.h -- `dem effects -cost`, the measured cost of each effect.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_APP_EFFECTS_H
#define DEM_APP_EFFECTS_H

#include "app/main.h"

/* `dem effects -cost [NAME ...]`. Measures on the calling rank, and prints. */
int dem_effects_cost(int argc, char **argv);

#endif
