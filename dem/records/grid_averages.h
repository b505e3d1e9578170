/*
 * grid_averages.h -- time averages in the cells of a grid with 95 % intervals; the same bits on any
 * number of ranks.
 *
 *   solidFraction   <V>/Vc                                 [1]     V volume of particles in the cell
 *   bulkDensity     <m>/Vc                                 [kg/m3] m their mass there
 *   velocity        <m v>/<m>                              [m/s]   mass-weighted mean
 *   temperature     (<m v.v>/<m> - |<m v>/<m>|^2)/3        [m2/s2] about the mean over time
 *   stress          (<W> - <m v v> + <m v><m v>/<m>)/Vc    [Pa]    contacts and motion, tension > 0
 *
 *   a scalar        <w s>/<w>                              [unit]  each particle scalar that is written
 *
 *   < > mean over samples; Vc volume of the cell; W virial of the contacts (records/virial.h);
 *   w capacity of the particle, where the scalar s has one (laws/scalar.h), else its mass, and 1
 *   for an amount
 *
 * The fraction of a particle that belongs to a cell is the product of its fractions in three slabs,
 * each the volume of a sphere between two parallel planes: exact where only faces of one direction
 * cut the sphere; the sum over cells is always its volume. Mass, momentum, virial and scalars are
 * distributed like the volume.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "records/snapshot.h"
#include "laws/interaction_table.h"
#include "records/grid_sums.h"

struct dem_state;

struct dem_scalar_average             /* accumulators of a particle scalar */
{
    int index;                   /* of the interaction table */
    const char *name;
    struct dem_grid_sums sums;
};

struct dem_grid_average               /* accumulators of one grid */
{
    struct dem_averages_entry entry;
    int64_t next;                /* number of the next sample */
    struct dem_grid_sums sums;   /* all but scalars */
    double *virial;
    size_t virial_capacity;
    int scalars;
    struct dem_scalar_average scalar[DEM_SCALARS];
};

struct dem_grid_averages
{
    struct dem_grid_average *grid;
    int grids;
};

/* Set up n grids (names stay the caller's), with the scalars of the frozen table. Samples before
   `time` [s] are skipped. Only the rank with `collects` (the first) allocates block sums. */
int dem_grid_averages_init(struct dem_grid_averages *, const struct dem_averages_entry *, int n,
                           const struct dem_interaction_table *, double time, int collects);
void dem_grid_averages_free(struct dem_grid_averages *);

/* 1 when a sample of a grid is due at this time [s]. */
int dem_grid_averages_due(const struct dem_grid_averages *, double time);

/* Collective. Sample the grids that are due at the present time; call after the contact forces
   have been computed. Returns `status`, the status of the step so far; when that is DEM_OK,
   DEM_ERROR_NUMBER on the rank of a particle whose numbers are too large. All ranks skip such a
   sample; the error reaches them when the ranks next agree on the status. */
int dem_grid_averages_sample(struct dem_grid_averages *, const struct dem_state *, int status);

/* Write the files of every grid that has samples into `folder`, by the first rank. */
int dem_grid_averages_write(const struct dem_grid_averages *, const struct dem_state *,
                            const char *folder);

/* Save and restore the sums of the first rank, for a restart. dem_grid_averages_spans describes them
   as spans of memory that are valid until the next sample; the caller frees *record and *span.
   dem_grid_averages_restore restores them from the bytes of the file `path`: a grid continues when
   its name, box, cells, start and interval are unchanged, and begins anew otherwise; so does each scalar of it. */
struct dem_grid_average_record;
int dem_grid_averages_spans(const struct dem_grid_averages *, struct dem_grid_average_record **,
                            struct dem_span **, int *n);
int dem_grid_averages_restore(struct dem_grid_averages *, const char *path, const char *bytes,
                              size_t size);
