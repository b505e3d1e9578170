/*
 * main_bonds.h -- the program's bonds: pictures of those that hold, and bonds.csv of those that broke.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MAIN_BONDS_H
#define DEM_MAIN_BONDS_H

#include "dem.h"
#include "main.h"
#include "main_output.h"

/* Rows of an earlier run in this folder that are later than the start of this one [s] go. */
int dem_bond_rows_begin(const struct dem_program *, const struct dem *, const char *folder, double start);

/* Collective. Append a row for each bond that broke since the last call; the file is made with the first. */
int dem_bond_rows_tell(const struct dem_program *, struct dem *, const struct dem_output *);

/* Collective. A picture of the bonds that hold. On the first rank `bonds_NNNNNN.vtp` and its place in bonds.pvd. */
int dem_bond_picture(struct dem *, const char *folder, int64_t number, double time);

#endif
