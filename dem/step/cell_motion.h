/*
 * cell_motion.h -- a step of a periodic domain that deforms (particles/cell.h): its lengths, the drift of
 * the particles, the neighbor lists; and the control of its stresses.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "contacts/pairs.h"
#include "laws/batch.h"

struct dem_state;
struct dem_gathered;

/* Drift over dt [s] to state->time. Returns the largest speed u of this rank [m/s]; infinite when one is
   not a number. */
double dem_cell_drift(struct dem_state *, double dt);

/* A list has been made at the present lengths. */
void dem_cell_list_made(struct dem_state *, int list);

/* The cell has become so narrow that a particle reaches its own image, or so wide that its unit of length
   is too small. */
int dem_cell_check(const struct dem_state *);

/* Set lengths and offset [m]: domain, periodic shifts, lists. */
void dem_cell_set_lengths(struct dem_state *, const double length[3], double offset);

/* While the history of contacts is saved: take whole lengths off the offset. */
void dem_cell_reduce_offset(struct dem_state *);

/* Add D r to the relative velocities of a batch of pairs. */
void dem_cell_add_velocities(const struct dem_state *, int n, struct dem_gathered *);

/* 1 in steps after which the stress is measured for its control. */
int dem_cell_control_due(const struct dem_state *);

/* Collective. Measure the stress and choose the rates of the held axes until the next time. */
int dem_cell_control(struct dem_state *);

/* Keep lengths, rates and strain of a cell with the backup of a run, and take them back. */
void dem_cell_backup(struct dem_state *);
void dem_cell_restore(struct dem_state *);
