/*
 * bonds_csv.h -- output of bonds by `dem run`: bonds.csv of broken bonds, VTK files of intact ones.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_APP_BONDS_CSV_H
#define DEM_APP_BONDS_CSV_H

#include "dem.h"
#include "app/main.h"
#include "app/output_files.h"

/* Collective. Remove the rows of an earlier run in this folder that are later than the start of
   this one [s]. */
int dem_bond_rows_begin(const struct dem_program *, const struct dem *,
                        const struct dem_output *);

/* Collective. Append a row for each bond that broke since the last call; the file is created
   with the first. */
int dem_bond_rows_append(const struct dem_program *, struct dem *, const struct dem_output *);

/* Collective. Write the intact bonds: the first rank writes bonds_NNNNNN.vtp and its entry in
   bonds.pvd. */
int dem_bonds_write_vtk(struct dem *, const char *folder, int64_t number, double time);

#endif
