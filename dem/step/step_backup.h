/*
 * step_backup.h -- the backup of a run, between the steps and within one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"
#include "step/sweep_bodies.h"

/* Collective. Copy the present state into the backup, unless it holds a number that is not a
   number; then the previous backup stays. */
int dem_step_backup(struct dem_state *);

/* Collective, in a step before its kick, with the status of this rank. Velocities are half a kick
   behind: the copy gets this half kick, the run itself does not. NULL: none. */
int dem_step_backup_ahead(struct dem_state *, int status, const struct dem_body_sweep *half_kick);
