/*
 * folder_lock.h -- one run at a time in a folder: a file `lock` with the process and the host of the
 * run, locked by the kernel as long as the process lives.
 *
 * A run that was killed leaves the file but not the kernel's lock, so the next run takes it over. On a
 * file system without locks the process is looked for instead, on the same host. dem.h describes
 * the functions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_CORE_FOLDER_LOCK_H
#define DEM_CORE_FOLDER_LOCK_H

struct dem_folder_lock;

int dem_folder_lock(struct dem_folder_lock *, const char *folder);
void dem_folder_unlock(struct dem_folder_lock *);

#endif
