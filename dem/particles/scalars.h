/*
 * scalars.h -- the columns of the particle scalars of a scene (laws/scalar.h).
 *
 * Scalar k of the interaction table is the column DEM_COLUMNS + k of the particles; the columns of
 * exchanged scalars follow.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/interaction_table.h"
#include "particles/particles.h"
#include "particles/scalar_entry.h"

/* Add the columns of all scalars to particles just initialised, and choose those that ghosts and
   batches have. */
int dem_scalars_add_columns(struct dem_particles *, const struct dem_interaction_table *);

/* The values of a scalar. */
static inline double *dem_scalar_values(const struct dem_particles *p, int scalar)
{
    return p->column[DEM_COLUMNS + scalar].data;
}

/* The values of a scalar by name; NULL when the scene does not have it. */
double *dem_scalar_values_of(const struct dem_particles *, const struct dem_interaction_table *,
                             const char *name);

/* A column of the exchange of a scalar; NULL when it is not exchanged. */
double *dem_scalar_exchange_values(const struct dem_particles *,
                                   const struct dem_interaction_table *, int scalar,
                                   enum dem_scalar_column);

/* Begin a window: clear what is summed in it, store the values. End it: the responses, from what
   each particle received (laws/scalar.h, docs/theory-coupling.md, "Exchange"). */
void dem_scalars_begin_window(struct dem_particles *, const struct dem_interaction_table *);
void dem_scalars_begin_particle(struct dem_particles *, const struct dem_interaction_table *,
                                size_t particle);    /* one that arrives within a window */
void dem_scalars_end_window(struct dem_particles *, const struct dem_interaction_table *);

/* DEM_ERROR_NUMBER for the first particle whose scalar is not a number or out of its range; `when`
   ends the sentence: " in step 17". */
int dem_scalars_check(const struct dem_particles *, const struct dem_interaction_table *,
                      const char *when);

/* The value that an entry of a scene gives to particle `number`; `seed` and these choose the random
   number of a range. */
double dem_scalar_draw(const struct dem_scalar_entry *, int scalar, uint64_t seed, uint64_t number);
