/*
 * snapshot_validate.h -- refuse values that no run has written, in a file with correct checksums.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "records/snapshot_header.h"

/* Check steps, times and flow records; the counts of the header have been checked before.
   DEM_ERROR_FILE with the quantity and its value. */
int dem_snapshot_validate_header(const char *path, const struct dem_snapshot_header *);

/* Check one packed particle: valid id, finite numbers, physical position and speed, inertia
   that matches its mass. DEM_ERROR_FILE with the particle's id and the value. Not
   collective. */
int dem_snapshot_validate_particle(const char *path, const struct dem_snapshot_header *,
                                   const double *packed);

/* Check that the history of one packed contact is finite. DEM_ERROR_FILE with the id of a
   partner. Not collective. */
int dem_snapshot_validate_contact(const char *path, const struct dem_snapshot_header *,
                                  const double *packed);
