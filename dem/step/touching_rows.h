/*
 * touching_rows.h -- compaction: contact forces of a stretch of rows of which few touch. Only those that do
 * become batches, with the same bits.
 *
 * In an agitated bed most candidate contacts are apart. The distance of a row takes a small part of the
 * time of its geometry and laws.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "contacts/contact_batch.h"
#include "ranks/dem_state.h"
#include "step/store_forces.h"

/* 1 when the rows of a class are swept so: pairs without forces past touching, scalars or energy balance,
   of which few touched at the last prune. */
int dem_touching_rows_pay(const struct dem_state *, const struct dem_effect_list *);

/* The forces of `rows` rows of a class from `row` on, at most DEM_STRETCH_ROWS, into the slots `to`; the
   history of the rows that do not touch is 0. */
void dem_touching_rows_sweep(struct dem_state *, struct dem_contact_workspace *,
                             const struct dem_effect_list *, uint32_t row, int rows,
                             const struct dem_batch_forces *to);
