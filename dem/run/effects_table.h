/*
 * effects_table.h -- effects.csv, the table that names the effects behind the results of a folder.
 *
 *     time[s],effects
 *     0,gravity hertz dry mindlin gidaspow pressureGradient
 *     0.006,gravity hertz dry mindlin wenYu pressureGradient
 *
 * From the time of a row until the time of the next one these effects act. The file stands beside
 * the other tables, whose first line has the names of columns, so that any reader of CSV takes them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

/* Enter the effects (names, separated by spaces) of a run that begins at this time [s] into
   FOLDER/effects.csv. Rows of an earlier run from then on are removed, and a row that repeats the
   effects of the row above is left out. By one rank. */
int dem_effects_table_begin(const char *folder, double time, const char *effects);
