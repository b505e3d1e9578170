/*
 * habits.h -- words of other codes that mean one of ours though they are spelt otherwise.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_BASE_HABITS_H
#define DEM_BASE_HABITS_H

/* Null when `foreign` is no habit for `ours`; else what to add about the value, mostly nothing (""). */
const char *dem_habit(const char *foreign, const char *ours);

#endif
