/*
 * main_effects.h -- `dem effects`, and what each effect takes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MAIN_EFFECTS_H
#define DEM_MAIN_EFFECTS_H

#include "main.h"

/* `dem effects -cost [WORD ...]`: measured now, by the rank that calls. */
int dem_effects_cost(int argc, char **argv);

#endif
