/*
 * hot_chain.h -- the commonest chain, hertz, dry and mindlin between particles, in one loop.
 *
 * Geometry, laws and forces of a row stay in registers: no column of the tray between them is written and read again. The
 * operations are those of the effects' own loops, on a row, in the same order: the bits are the same (tests/physics/test_hot_chain).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_HOT_CHAIN_H
#define DEM_STEP_HOT_CHAIN_H

#include "step/tray.h"

enum
{
    DEM_HOT_NORMAL,
    DEM_HOT_DAMPING,
    DEM_HOT_FRICTION,
    DEM_HOT_LINKS
};

/* 1 when these are the laws, and nothing else. */
int dem_hot_chain_is(const struct dem_chain *);

/* After dem_tray_gather: the laws, and the push of every lane. `memory`: mindlin's columns at the tray's rows. 1 when a row may
   overlap by more than `worst` of the lesser diameter, or a force is not a number; overlap and forces are in the tray for that. */
int dem_hot_chain_act(const struct dem_chain *, struct dem_tray *, double worst, double *const *memory, struct dem_push *);

#endif
