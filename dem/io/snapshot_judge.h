/*
 * snapshot_judge.h -- refuse what no run has written, in a file whose checksums are right.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_SNAPSHOT_JUDGE_H
#define DEM_IO_SNAPSHOT_JUDGE_H

#include "io/snapshot_head.h"

/* Steps, times and the books of streams and outlets; counts have been looked at. DEM_ERROR_FILE with the thing and its value. */
int dem_snapshot_judge_head(const char *path, const struct dem_snapshot_head *);

/* One particle as it lies in the file: its id, numbers that are finite, a place and a speed that physics has, inertia that goes with
   its mass. DEM_ERROR_FILE with the particle's id, the value and the limit. Not collective. */
int dem_snapshot_judge_particle(const char *path, const struct dem_snapshot_head *, const double *packed);

/* What one row remembers is finite. DEM_ERROR_FILE with the partners' ids. Not collective. */
int dem_snapshot_judge_row(const char *path, const struct dem_snapshot_head *, const double *packed);

#endif
