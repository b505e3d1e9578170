/*
 * stored_names.h -- the names that columns and contact history have in snapshots, where these differ
 * from the names in the code.
 *
 * Snapshots match columns and history by name, so a name that was once written stays. A name that is
 * not in the table is the same in both. To rename a column or history column, add a row with the new
 * name and the name in snapshots of before.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_RECORDS_STORED_NAMES_H
#define DEM_RECORDS_STORED_NAMES_H

/* The name in snapshots of a name in the code, and the reverse. Without a row in the table the
   argument itself is returned; otherwise a string of static storage. */
const char *dem_stored_name(const char *name);
const char *dem_name_of_stored(const char *stored);

/* 1 when a name in the code and a name in a snapshot denote the same column. */
int dem_is_stored_as(const char *name, const char *stored);

#endif
