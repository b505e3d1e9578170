/*
 * program.h -- the program of a device: the laws of a frozen interaction table on rows and particles,
 * composed into one OpenCL C text. What the scene does not name is not in it.
 *
 * Kernels: rows_<class> for each pair class (rows.cl), bodies and clear_apart (bodies.cl), lists_*
 * (lists.cl), scan_* (scan.cl), test_<class> (test.cl).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/text.h"
#include "laws/interaction_table.h"
#include "particles/particles.h"
#include "records/energy_balance.h"
#include "walls/walls.h"

/* The particles give the columns of a fluid; the walls, whether any is curved or moves, and whether
   there are several facets; the balance, whether energies are summed. The caller frees the text. */
int dem_device_program(const struct dem_interaction_table *, const struct dem_particles *,
                       const struct dem_walls *, const struct dem_energy_balance *,
                       struct dem_text *);

/* 1 when contacts with walls have a kernel of their own (facets.cl). */
int dem_device_has_facets(const struct dem_walls *);

/* Why an effect cannot be in a program, as the end of a sentence, or NULL. */
const char *dem_device_effect_refusal(const struct dem_effect *);
