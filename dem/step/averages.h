/*
 * averages.h -- means over time in the boxes of a grid, with 95 % intervals, the same bits on any number of ranks.
 *
 *   solidFraction   <V>/Vc                                        [1]       V volume of particles inside the cell
 *   bulkDensity     <m>/Vc                                        [kg/m3]   m their mass there
 *   velocity        <m v>/<m>                                     [m/s]     mean of the mass that was there
 *   temperature     (<m v.v>/<m> - |<m v>/<m>|^2)/3               [m2/s2]   about the mean over time
 *   stress          (<W> - <m v v> + <m v><m v>/<m>)/Vc           [Pa]      contacts and motion, tension positive
 *
 *   < >  mean over samples;  W see virial.h, given to cells as the particle's volume is
 *
 * A particle's share of a cell is the product of its shares of three slabs, each the volume of a sphere between two
 * planes: exact where faces of one direction cut it, the sum over cells always its volume.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_AVERAGES_H
#define DEM_STEP_AVERAGES_H

#include "base/blocks.h"
#include "io/averages.h"
#include "io/snapshot.h"

struct dem_parts;

struct dem_average                                            /* one grid */
{
    struct dem_average_plan plan;
    int64_t next;                                             /* number of the sample that comes next */
    int64_t *sum;                                             /* cells x 17, whole numbers: their order does not matter */
    double *sample, *virial;
    size_t virial_room;
    struct dem_blocks blocks;                                 /* on the first rank */
};

struct dem_averages
{
    struct dem_average *grid;
    int grids;
};

/* Take over what was read (names stay the caller's). Samples before `time` [s] are past. Only who collects (the first
   rank) holds blocks. */
int dem_averages_init(struct dem_averages *, const struct dem_average_plan *, int n, double time, int collects);
void dem_averages_free(struct dem_averages *);

/* 1 when a grid is due at this time. */
int dem_averages_due(const struct dem_averages *, double time);

/* Collective. Sample the grids that are due at the present time of the parts. After a sweep. The status that the step has so far comes
   back; where that is success DEM_ERROR_NUMBER with a sentence, on the rank of a particle whose numbers can't be summed: all ranks leave such a
   sample out, and hear of it when they next agree. */
int dem_averages_sample(struct dem_averages *, const struct dem_parts *, int status);

/* The files of every grid that has samples, by the first rank. */
int dem_averages_save(const struct dem_averages *, const struct dem_parts *, const char *folder);

/* The first rank's sums, for a run that goes on: as spans of memory that stay until the next sample (the caller frees both), and
   taken back from their bytes. A grid goes on when name, box, cells, start and interval are those of then. */
struct dem_average_record;
int dem_averages_spans(const struct dem_averages *, struct dem_average_record **, struct dem_span **, int *n);
int dem_averages_resume(struct dem_averages *, const char *path, const char *bytes, size_t size);

#endif
